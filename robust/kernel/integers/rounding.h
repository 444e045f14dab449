// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "robust/kernel/integers/int192.h"

/// Rounding to the nearest double, ties to even, by integers alone: the same in every floating-point environment.
///
/// Subnormals are rounded once, to the digits that they have. From 2^1024 - 2^970 on the result is infinite. Zero is
/// +0.0; a nonzero number keeps its sign even if it rounds to zero.
namespace touchstone::robust::kernel {

/// (negative ? -1 : 1) * (leading + tail) * 2^exponent, where leading >= 2^63 and the tail is 0, or somewhere inside
/// (0, 1).
double round_leading(bool negative, std::uint64_t leading, bool tail, std::int64_t exponent);

/// n * 2^exponent
double round_scaled(Int128 n, std::int64_t exponent);
inline double round_scaled(std::int64_t n, std::int64_t exponent) { return round_scaled(Int128{n}, exponent); }
double round_scaled(const mpz_class& n, std::int64_t exponent);

/// (n / d) * 2^exponent, d != 0
double round_quotient(Int128 n, Int128 d, std::int64_t exponent = 0);
double round_quotient(const Int192& n, Int128 d, std::int64_t exponent = 0);
double round_quotient(const mpz_class& n, const mpz_class& d, std::int64_t exponent = 0);

/// sqrt((n / d) * 2^exponent), n / d >= 0
double round_square_root(const mpz_class& n, const mpz_class& d, std::int64_t exponent = 0);

/// A nonnegative size with the given sign; 0 stays +0.0.
double with_sign(double size, int sign);

}  // namespace touchstone::robust::kernel
