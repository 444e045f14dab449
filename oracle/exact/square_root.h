// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/truth.h"

namespace touchstone::oracle {

/// A number that is certain enough to be rounded. Where it is rational the three are equal. Otherwise the true one lies
/// between low and high, all three round to the same double with the same sign, and value is within 2^-60 units in the
/// last place of it.
struct Enclosed {
  Rational value, low, high;
  bool rational() const { return low == high; }
};

/// sign(sign) * sqrt(square), square >= 0, by comparing squares: the digits are found one by one, each as the last
/// whose square is not too large. A root that is not rational is neither a double nor half-way between two, so that
/// some number of digits is enough.
Enclosed signed_root(const Rational& square, int sign);

}  // namespace touchstone::oracle
