// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "robust/kernel/integers/integers.h"

/// Directed rounding, computed from integers: the same in every floating-point environment.
namespace touchstone::robust::kernel {

/// The greatest double that is not above n * 2^exponent: above the range the greatest finite double, below it
/// -infinity; 0 is 0.0.
double round_down(Int128 n, std::int64_t exponent);
double round_down(const mpz_class& n, std::int64_t exponent);

/// The least double that is not below n * 2^exponent.
double round_up(Int128 n, std::int64_t exponent);
double round_up(const mpz_class& n, std::int64_t exponent);

}  // namespace touchstone::robust::kernel
