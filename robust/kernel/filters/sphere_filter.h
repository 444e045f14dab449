// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for balls in space: the model, the guards and the rules (1), (4), (5) and (6) of filters.h.
namespace touchstone::robust::filters {

/// The sign of (a.radius + b.radius)^2 - |b.center - a.center|^2: positive if the balls overlap, negative if they are
/// disjoint. The radii are not negative.
///
/// Let r2 be the square of the computed sum of the radii, i and o the exact squares of the sum and of the distance, O
/// the computed square of the distance, and I the square of the sum, as it is computed or, where FMA leaves its
/// rounding out, r2 itself; that may happen in the difference and in the sum of both on its own. i (1 - u)^2 <= r2 <= i
/// (1 + u)^2, and O is o times five factors between 1 - u and 1 + u: a difference twice, a product, two sums. If the
/// difference is positive and should not be, with q = (1 - u)^5 / (1 + u)^2 it is at most (1 + u - q) / (1 + q) of the
/// sum (I rounded up in the one and not at all in the other); if it is negative and should not be, with p = (1 + u)^5 /
/// (1 - u)^2 at most (p - 1 + u) / (p + 1 - u) of it (I rounded down in both). These are 4 u + ... both. m = 3. C = 4 u
/// + 24 u^2: at u = 1/16, 1.323 and 1.256 < 1.375 in units of 4 u. (Looser than it could be: the roundings of the
/// distance and of the sum of the radii are taken for independent, but where the sign is in doubt these two are nearly
/// equal. A quarter of the bound is too small.)
///
/// The guard holds the four factors F, the computed coordinates and sum, to a sum of their squares of about H^2, and
/// so, by Cauchy's inequality, |F| to a sum of 2 H (1 + u). By (1) F = f (1 + e) + h with |h| <= 4 n, so F^2 is off by
/// 2 |F| |h| + 3 h^2 <= 8 n |F| + 48 n^2 besides what is counted above, and by n^2 where it is read as zero: 17 n H for
/// all, with n for each of four products and 4 n for each of three sums less than 1.2 (17 n H + 17 n) <= 26 n H; and 3
/// n H in the bound. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign spheres(const Sphere3<Float>& a, const Sphere3<Float>& b) {
  using B = Bounds<Float, Format>;
  const Vector3<Float> v = b.center - a.center;
  const Float reach = a.radius + b.radius;
  const Float inside = reach * reach, outside = v.x * v.x + v.y * v.y + v.z * v.z;
  const Float sum = inside + outside;
  return certain<Float, Format>(inside - outside, B::template relative<8, 24>() * sum + B::absolute(), sum,
                                B::high_squared());
}

}  // namespace touchstone::robust::filters
