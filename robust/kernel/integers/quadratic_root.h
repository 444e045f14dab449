// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/kernel/integers/rounding.h"

/// Roots of quadratic polynomials, by integers alone: the same in every floating-point environment.
namespace touchstone::robust::kernel {

/// 1, 0, -1: the sign of a b - c d, of any four numbers.
int compare_products(UInt128 a, UInt128 b, UInt128 c, UInt128 d);

/// 1, 0, -1: the sign of n + sign sqrt(square), square >= 0, sign 1 or -1.
int sign_with_root(const mpz_class& n, int sign, const mpz_class& square);

/// (n + sign sqrt(square)) / d * 2^exponent, rounded as in rounding.h; square >= 0, sign 1 or -1, d != 0.
double round_quadratic_root(const mpz_class& n, int sign, const mpz_class& square, const mpz_class& d,
                            std::int64_t exponent = 0);

}  // namespace touchstone::robust::kernel
