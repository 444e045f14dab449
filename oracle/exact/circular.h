// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/truth.h"

namespace touchstone::oracle {

/// low < true value < high, and a value between them, closer to the true one.
struct Enclosure {
  Rational low, value, high;
};

struct CosineAndSine {
  Enclosure cosine, sine;
};

/// cos u and sin u of a finite u other than 0, each enclosed to within 2^(1 - bits) of itself. u of any size: MPFR
/// reduces it exactly.
CosineAndSine cosine_and_sine(double u, int bits);

/// The whole number of quarter turns nearest to u (or next to it): |u - k pi/2| < 0.8.
mpz_class quarter_turns(double u);

}  // namespace touchstone::oracle
