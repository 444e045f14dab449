// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "robust/kernel/filters/filters.h"

/// The first stage for planes in space: the model, the guards and the rules (4) and (5) of filters.h.
namespace touchstone::robust::filters {

/// The sign of n.x * p.x + n.y * p.y + n.z * p.z + offset: positive in front of the plane. Unknown if the normal may be
/// zero.
///
/// Let s be the sum of the magnitudes of the three exact products and the offset. A product goes through its own
/// rounding and at most two sums before the last one, so what that adds is off by at most ((1 + u)^3 - 1) s (FMA only
/// leaves roundings out), and by (4) a value of the wrong sign is at most (1 + u) times that. The sums N and P of the
/// magnitudes of n's and p's coordinates, which the guard needs, make a product of at least the three products'
/// magnitudes; N P and the offset's magnitude are computed as at least (1 - u)^6 s, and the bound has two operations
/// more: C (1 - u)^8 >= (1 + u) ((1 + u)^3 - 1) = 3 u + .... C = 3 u + 48 u^2: at u = 1/16, 1.895 < 2 in units of 3 u.
/// (Looser than it could be: N P holds nine products, and the terms of a sum that cancels are smaller than s.)
/// Underflow costs 2.2 n H for a factor read as zero and n for its rounding, three times, and 4 n for each of three
/// sums, all times 1.2; 11 n H each for N and P, times C; and 3 n H in the bound: A pays for it. The offset has no
/// guard: where the terms overflow, so does the bound, and nothing is greater; where the value alone does, its sign is
/// the offset's, and right. Proved.
template <class Float, class Format = FloatFormat<Float>>
Sign plane(const Plane<Float>& plane, const Point3<Float>& p) {
  using B = Bounds<Float, Format>;
  const Vector3<Float>& n = plane.normal;
  const Float value = n.x * p.x + n.y * p.y + n.z * p.z + plane.offset;
  const Float of_normal = extent<Float, Format>(n.x, n.y, n.z), of_point = extent<Float, Format>(p.x, p.y, p.z);
  const Float terms = of_normal * of_point + Format::magnitude(plane.offset);
  // Every branch here is predictable, except for the sign, which is no branch.
  if (!(Format::magnitude(value) > B::template relative<6, 48>() * terms + B::absolute())) [[unlikely]]
    return Sign::unknown;
  if (!(of_normal + of_point <= B::high())) [[unlikely]]
    return Sign::unknown;
  if (!(of_normal > Float())) [[unlikely]]
    return Sign::unknown;
  return value > Float() ? Sign::positive : Sign::negative;
}

}  // namespace touchstone::robust::filters
