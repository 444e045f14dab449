// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// Whole numbers of some unit 2^-bits, with the true value between them.
struct Between {
  mpz_class low, high;
};

struct CosineAndSine {
  Between cosine, sine;
};

/// Of an angle u that is at most 1 away from so many quarter turns, and not exactly so many as far as the bits show.
CosineAndSine cosine_and_sine(const Rational& u, const mpz_class& turns, long bits);

/// What a certificate says of its bits: 1 to 8192.
long whole_bits(const Rational& precision);

}  // namespace touchstone::certify
