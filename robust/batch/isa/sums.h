// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/kernels.h"

/// Sums and products with their rounding errors, computed by an FMA, and exact signs of sums of many terms. For
/// instruction sets that have an FMA.
namespace touchstone::robust::batch::isa {
namespace {

/// The lanes in which a number is certainly positive, negative, or 0.
struct Signs {
  Mask positive = 0, negative = 0, zero = 0;
  Mask known() const { return positive | negative | zero; }
  Signs of(Mask asked) const { return {positive & asked, negative & asked, zero & asked}; }
};

#ifdef TOUCHSTONE_SECOND_STAGE

/// x + y and its exact rounding error: sum and error of Knuth's two-sum. If anything in it overflows, the head or the
/// tail is infinite or NaN.
struct Sum {
  Lanes head, tail;
  Sum(Lanes x, Lanes y) : head(x + y), tail(x) {
    const Lanes y_part = head - x, x_part = head - y_part;
    tail = (x - x_part) + (y - y_part);
  }
};

/// The same for x - y.
struct Difference {
  Lanes head, tail;
  Difference(Lanes x, Lanes y) : head(x - y), tail(x) {
    const Lanes y_part = x - head, x_part = head + y_part;
    tail = (x - x_part) + (y_part - y);
  }
};

/// x y and its rounding error: exact if that does not underflow; otherwise off by 2^-1075 at most.
struct Product {
  Lanes head, tail;
  Product(Lanes x, Lanes y) : head(x * y), tail(multiply_add(x, y, same(0) - head)) {}
};

Lanes opposite(Lanes x) { return same(0) - x; }

/// The lanes of numbers that are 0 or between 2^-480 and 2^480: multiples of 2^-532. So are both parts of their
/// differences; products of two such parts are multiples of 2^-1064, and less than 2^963. No result computed from them
/// underflows or overflows, and all heads and tails are exact. The window of cubes ends at 2^250.
Mask in_window(Lanes x, double greatest = 0x1p480) {
  const Lanes size = magnitude(x);
  return (not_below(size, same(1 / greatest)) & not_below(same(greatest), size)) | equal(size, same(0));
}

/// 2^620 if the size is less than 2^-240, 2^-620 if it is more than 2^240, 1 otherwise.
Lanes factor_of(Lanes size) {
  const Lanes up = same(0x1p620), down = same(0x1p-620), low = same(0x1p-240), high = same(0x1p240);
  return where_above(size, high, down, where_above(low, size, up, same(1)));
}

/// Multiplies the numbers of each lane by one power of two if the greatest of them is far from 1 and all products are
/// exact: each is in the window, and 0 only if the number is 0. With the factor 2^620 none can be too large.
template <std::size_t n>
void bring_near_one(Lanes (&numbers)[n]) {
  Lanes size = magnitude(numbers[0]);
  for (std::size_t k = 1; k < n; ++k) size = greater(size, magnitude(numbers[k]));
  const Mask far = above(size, same(0x1p240)) | above(same(0x1p-240), size);
  if (far == 0) return;
  Lanes factor = factor_of(size);
  Mask exact = all_lanes;
  for (const Lanes& number : numbers) {
    const Lanes scaled = number * factor;
    exact &= in_window(scaled) & (equal(number, same(0)) | ~equal(scaled, same(0)));
  }
  if ((far & ~exact) != 0) {
    double factors[lanes];
    std::memcpy(factors, &factor.v, sizeof factors);
    for (std::size_t i = 0; i < lanes; ++i)
      if ((exact >> i & 1) == 0) factors[i] = 1;
    factor = Lanes::at(factors);
  }
  for (Lanes& number : numbers) number = number * factor;
}

/// The signs, in the asked lanes, of sums of terms that are multiples of 2^-1074 and so small that nothing overflows.
/// The terms are best sorted by size, the greatest last.
///
/// A pass adds each term to the next and stores the rounding error in its place: the exact sum of all terms stays the
/// same (Ogita, Rump and Oishi, Accurate sum and dot product, 2005). The sign of the last term is that of the sum if
/// its magnitude exceeds the sum of the magnitudes of all others. As computed that sum is at least (1 - v)^n of the
/// exact one, or exact if it is less than 2^-1022: a factor of 1 + 2^-40 is enough for n up to 2^12. If the others are
/// all 0 the last term is the sum. Each pass leaves about 2^-52 of the remainder; after most_passes a lane is left to
/// the other stages.
template <std::size_t n>
Signs signs_of_sums(Lanes (&terms)[n], Mask asked) {
  constexpr int most_passes = 6;
  Signs found;
  for (int pass = 0; pass < most_passes && (asked & ~found.known()) != 0; ++pass) {
    Lanes others = same(0);
    for (std::size_t i = 1; i < n; ++i) {
      const Sum sum(terms[i], terms[i - 1]);
      terms[i] = sum.head, terms[i - 1] = sum.tail;
      others = others + magnitude(sum.tail);
    }
    const Mask certain = above(magnitude(terms[n - 1]), others * same(1 + 0x1p-40)), below = negative(terms[n - 1]);
    found.positive |= certain & ~below;
    found.negative |= certain & below;
    found.zero |= equal(magnitude(terms[n - 1]) + others, same(0));
  }
  return found;
}

#endif

}  // namespace
}  // namespace touchstone::robust::batch::isa
