// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "robust/kernel/filters/box_differences.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for a ball and a box: the model, the guards and the rules (1), (4), (5) and (6) of filters.h.
namespace touchstone::robust::filters {

/// On one axis: the computed distance of the center beyond the box, 0 if it is not beyond; and max - min.
///
/// For min <= max at most one of min - c and c - max is positive, even rounded: rounding keeps the sign of a difference
/// or makes it 0. So the greatest of these and 0 is off by no more than one difference, and by 2 n more if numbers are
/// read as zero when they are compared and selected. It is NaN if c is.
template <class Float>
struct BeyondInterval {
  Float beyond, extent;
};
template <class Float>
BeyondInterval<Float> beyond_interval(const Float& c, const Float& min, const Float& max) {
  const Float below = min - c, above = c - max, more = below < above ? above : below;
  return {more < Float() ? Float() : more, max - min};
}

/// The sign of r^2 minus the squared distance of a ball's center from a box that has an interior: positive if the ball
/// overlaps it, negative if they are disjoint. r >= 0. Unknown if a box is flat, or may be, or has min > max, and if a
/// number is NaN or infinite.
///
/// i, o, I, O: the exact squares of the radius and of the distance, and the computed ones; I may also be i itself,
/// where FMA leaves its rounding out, in the difference and in the sum of both on its own. i (1 - u) <= I <= i (1 + u),
/// and O is o times five factors between 1 - u and 1 + u, as for two balls (sphere_filter.h). If the difference is
/// positive and should not be, with q = (1 - u)^5 it is at most (1 + u - q) / (1 + q) of the sum; if it is negative and
/// should not be, with p = (1 + u)^5 at most (p - 1 + u) / (p + 1 - u) of it. These are 3 u + ... both. m = 3. C = 3 u
/// + 18 u^2: at u = 1/16, (1 + u) / (1 - u)^3 times these is 1.350 and 1.251, less than 1.375, in units of 3 u. The
/// absolute terms are those for two balls, or less: the radius is no difference.
///
/// Each extent is a difference of two numbers of the box: where it is positive and the sum of all is not infinite, no
/// number of the box is NaN or infinite (box_differences.h). Proved for two and three axes, beyond_interval included.
template <class Float, class Format = FloatFormat<Float>, class... Axes>
Sign ball_and_box(const Float& radius, const Axes&... axis) {
  using B = Bounds<Float, Format>;
  const Float inside = radius * radius, outside = ((axis.beyond * axis.beyond) + ...);
  const Float sum = inside + outside;
  const int proper = (static_cast<int>(axis.extent > Float()) & ...),
            bounded = (axis.extent + ...) <= B::high_squared();
  if ((proper & bounded) == 0) [[unlikely]]
    return Sign::unknown;
  return certain<Float, Format>(inside - outside, B::template relative<6, 18>() * sum + B::absolute(), sum,
                                B::high_squared());
}

}  // namespace touchstone::robust::filters
