// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "arithmetic/integer.h"

/// Pi and the circular functions on integers, with a bound of the error: fixed-point numbers with `bits` bits behind
/// the point. More bits give a narrower enclosure.
namespace touchstone::arithmetic {
inline namespace TOUCHSTONE_WORDS {

/// The number lies within `error` of n, both multiples of 2^-bits.
struct Near {
  Integer n;
  Integer error;
};

Near pi(std::int64_t bits);
/// The sine and the cosine of digits 2^exponent.
std::array<Near, 2> sine_cosine(const Integer& digits, std::int64_t exponent, std::int64_t bits);
/// The angle of (x, y) from the x axis, in (-pi, pi]; x and y are not both 0.
Near arc_tangent(const Integer& y, const Integer& x, std::int64_t bits);
/// The arc cosine of x 2^-places, which lies in [-1, 1].
Near arc_cosine(const Integer& x, std::int64_t places, std::int64_t bits);

}  // namespace TOUCHSTONE_WORDS
}  // namespace touchstone::arithmetic
