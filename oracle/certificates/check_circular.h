// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {

/// Integers in units of 2^-bits, with the true value between them.
struct Between {
  mpz_class low, high;
};

struct CosineAndSine {
  Between cosine, sine;
};

/// For an angle u that is at most 1 away from this many quarter turns, and not exactly equal as far as the bits show.
CosineAndSine cosine_and_sine(const Rational& u, const mpz_class& turns, std::int64_t bits);

/// The bits that a certificate states: 1 to 8192.
std::int64_t integer_bits(const Rational& precision);

}  // namespace touchstone::certify
