// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/rays.h"
#include "robust/kernel/filters/decode.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for segments against balls and discs: the model, the guards and the rules of filters.h.
namespace touchstone::robust::filters {

/// Decides whether a segment meets a ball. Positive: it does; negative: it does not.
///
/// As RayAndBall, with v from a to b: |c + t v|^2 - r^2 is start + 2 slope t + v . v t^2, and end at t = 1, where half
/// its derivative is slope_at_end = slope + v . v. The line misses the ball if value = slope^2 - v . v start is
/// negative, and the segment meets it if start or end is negative. If all are positive, the segment meets the ball if
/// it approaches at its start and parts at its end. In units of |c|^2, r^2 and |v|^2, whose sum is U; |c| |v| is at
/// most half of |c|^2 + |v|^2:
///
/// start: as for RayAndBall, C = 5 u + 128 u^2.
///
/// end: a product of c . c goes through two differences, the product, two sums, and three sums more, the last of which
/// is shared (4); the others go through no more. (1 + u)^7 - 1 in units of 2 U, of which (1 - u)^7 is computed; two
/// operations more: 14 u + ..., and 2.01 at u = 1/16. C = 28 u + 384 u^2, 3.25 there, for a reason that is given below.
///
/// value: a product of v . v start goes through five roundings for v . v, six for start and one, those of slope^2
/// through eleven; the last subtraction is shared. Both have their products among |v|^2 (2 |c|^2 + r^2), so twice |v|^2
/// (|c|^2 + r^2) are the units, of which (1 - u)^12 is computed; two operations more. C = 24 u + 1280 u^2: at u = 1/16,
/// 5.612 < 6.5.
///
/// slope is off by (1 + u)^5 - 1 in units of |c| |v|, and asked only where value and start are certainly positive. Then
/// its square, as computed, is more than a value's bound, 24 u |c|^2 |v|^2, which is more than the square of what slope
/// is off. slope_at_end is off by (1 + u)^6 - 1 in units of |c| |v| + |v|^2, the square of which is at most 2 |v|^2 U.
/// It is asked where value and end are certainly positive. Since value is slope_at_end^2 - v . v end too, the square of
/// slope_at_end is then more than |v|^2 end, and by its bound end is at least C (1 - u)^9 - 2 ((1 + u)^8 - 1) in units
/// of U, 12 u + ...: at u = 1/16, 0.57, where 2 ((1 + u)^6 - 1)^2, 72 u^2 + ..., is 0.385.
///
/// Guard and absolute terms: as for RayAndBall; v is off by 5 n as c is, so that value is off by less than 512 n G^3,
/// start and slope by less than 64 n G, end by less than 320 n G, slope_at_end by less than 128 n G; the bound of value
/// by less than 1000 n G^3. Where value exceeds 4096 n G^3, |v|^2 exceeds 2048 n G, so that |v|^2 end is more than the
/// square of what slope_at_end is off for underflow. Not proved by machine.
template <class Float, template <class> class Point, class Format = FloatFormat<Float>>
Sign segment_meets_ball(const Point<Float>& a, const Point<Float>& b, const Point<Float>& center, const Float& radius) {
  using B = Bounds<Float, Format>;
  const int g = Format::max_exponent / 6;
  const Float least = Format::above(power_of_two(12 + Format::min_exponent + g)),
              absolute = Format::above(power_of_two(12 + Format::min_exponent + 3 * g));
  const auto c = a - center, v = b - a;
  const Float square = radius * radius, way = dot(c, c), speed = dot(v, v), slope = dot(c, v), reach = way + square,
              size = reach + speed;
  const Float start = way - square, slope_at_end = slope + speed, end = (start + slope) + slope_at_end,
              value = slope * slope - speed * start;
  const int begins = Format::magnitude(start) > B::template relative<10, 128>() * reach + least,
            ends = Format::magnitude(end) > B::template relative<56, 384>() * size + least,
            passes = Format::magnitude(value) > B::template relative<48, 1280>() * (speed * reach) + absolute,
            guarded = size <= Format::above(power_of_two(2 * g));
  if ((begins & ends & passes & guarded) == 0) [[unlikely]] {  // one branch
    if ((guarded & ((begins & (start < Float())) | (ends & (end < Float())))) != 0) return Sign::positive;
    return (guarded & passes & (value < Float())) != 0 ? Sign::negative : Sign::unknown;
  }
  const Float nearest = start < end ? start : end;
  const int within = nearest < Float(), through = (slope < Float()) & (slope_at_end > Float());
  return ((value > Float()) & (within | through)) != 0 ? Sign::positive : Sign::negative;
}

}  // namespace touchstone::robust::filters
