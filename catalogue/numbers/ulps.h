// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

namespace touchstone::catalogue {

/// The exact value of a finite double, from its bits.
mpq_class exact_value(double value);

/// The distance of `answered` from `truth`, in units in the last place of the binary64 (or binary32) number nearest to
/// truth; 0 exactly if it is the correctly rounded one (nearest, ties to even; beyond the range the infinity). The
/// distance is below 1e300; NaN, or an infinity if the truth rounds to a finite number, gives infinity.
double distance_in_ulps(double answered, const mpq_class& truth, bool binary32 = false);

/// The number of the format nearest to `truth`, ties to even, as a double.
double nearest(const mpq_class& truth, bool binary32 = false);

}  // namespace touchstone::catalogue
