// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "oracle/truth.h"

namespace touchstone::oracle {

/// e with 2^e <= |value| < 2^(e+1); value is not zero.
std::int64_t binary_order(const Rational& value);

/// The exponent k of the unit in the last place at a value: doubles near it are the multiples of 2^k. -1074 at zero and
/// in the subnormal range; 971 and everything beyond the largest double is counted in 2^971.
int ulp_exponent(const Rational& value);

/// The double nearest to a rational, ties to even, computed from integers: right in every floating-point environment.
/// Zero gives +0.0; a nonzero value that rounds to zero keeps its sign; from 2^1024 - 2^970 on the result is infinite.
double nearest_double(const Rational& value);

/// The distance of a value, in its unit in the last place, from the nearest point where nearest_double jumps. At most
/// 1/2 below the largest double; 0 exactly at a halfway case.
Rational rounding_margin(const Rational& value);

}  // namespace touchstone::oracle
