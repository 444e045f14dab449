// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// The true value lies strictly between (nearest - width) * 2^exponent and (nearest + width) * 2^exponent.
struct Enclosure {
  Integer nearest, width;
  int exponent;
};

struct CosineAndSine {
  Enclosure cosine, sine;
};

/// cos u and sin u for a nonzero u, both narrower with more bits. u may have any size: MPFR reduces it exactly. A
/// double is an MPFR number, so its width is 1; a rational has to be rounded to one, which the width includes.
CosineAndSine cosine_and_sine(double u, int bits);
CosineAndSine cosine_and_sine(const Rational& u, int bits);

/// The number of quarter turns nearest to u (or next to it): |u - k pi/2| < 0.8.
mpz_class quarter_turns(double u);

}  // namespace touchstone::oracle
