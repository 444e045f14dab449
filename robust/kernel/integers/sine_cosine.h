// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// cos u and sin u in fixed point: each lies within `error` of n / 2^bits.
struct SineCosine {
  mpz_class sine, cosine;
  mpz_class error;
  std::uint64_t bits;
};

/// Accepts every finite u and uses only integers. The error is below 16 units for each term of the series, of which
/// there are fewer than bits; so it becomes arbitrarily small with more bits. bits >= 32.
SineCosine sine_cosine(double u, std::uint64_t bits);

/// pi * 2^bits, off by less than 1; cached for each thread with the most digits requested so far.
mpz_class pi(std::uint64_t bits);

}  // namespace touchstone::robust::kernel
