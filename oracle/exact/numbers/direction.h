// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// The angle of the vector (x, y) from the +x axis, counter-clockwise, lies in [low, high].
struct AngleBetween {
  Rational low, high;
};

/// In (0, 2 pi), by MPFR, rounded down and up to this many bits. The vector is neither 0 nor along +x.
AngleBetween angle_between(const Integer& x, const Integer& y, int bits);

}  // namespace touchstone::oracle
