// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/encoded_value.h"
#include "oracle/exact/numbers/surd.h"

namespace touchstone::catalogue {

/// The numbers of the truth: p + q sqrt(r), mostly rational.
using TrueNumber = oracle::Surd;
using EncodedTruth = EncodedValue<TrueNumber>;

/// The same as for rationals in catalogue/numbers/ulps.h.
double nearest(const TrueNumber& truth, bool binary32 = false);
double distance_in_ulps(double answered, const TrueNumber& truth, bool binary32 = false);

}  // namespace touchstone::catalogue
