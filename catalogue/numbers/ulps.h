// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

namespace touchstone::catalogue {

/// The exact value of a finite double, from its bits.
mpq_class exact_value(double value);

/// How far `answered` is from `truth`, in units in the last place of the binary64 (or binary32) number nearest to
/// truth; 0 exactly when it is the correctly rounded one (nearest, ties to even; beyond the range the infinity). A
/// distance below 1e300; NaN, or an infinity where the truth rounds to a finite number, gives infinity.
double distance_in_ulps(double answered, const mpq_class& truth, bool binary32 = false);

/// The number of the format that is nearest to `truth`, ties to even, as a double.
double nearest(const mpq_class& truth, bool binary32 = false);

}  // namespace touchstone::catalogue
