// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "robust/kernel/filters.h"

/// The first stage for planes in space: the model, the guards and the rules (4) and (5) of filters.h.
namespace touchstone::robust::filters {

/// The sign of n.x * p.x + n.y * p.y + n.z * p.z + offset: positive in front of the plane. Unknown where the normal may be zero.
///
/// Let s be the sum of the magnitudes of the three exact products and the offset. A product goes through its own rounding and at most two
/// sums before the last one, so what that adds is off by at most ((1 + u)^3 - 1) s (FMA only leaves roundings out), and by (4) a value
/// of the wrong sign is at most (1 + u) times that. The computed terms are at least (1 - u)^4 s, and the bound has two operations more:
/// C (1 - u)^6 >= (1 + u) ((1 + u)^3 - 1) = 3 u + .... C = 3 u + 32 u^2: at u = 1/16, 1.665 < 1.667 in units of 3 u. (Looser by two or
/// so than it could be: the terms of a sum that cancels are smaller than s.) Underflow costs 2.2 n H for a factor read as zero and n for
/// its rounding, three times, and 4 n for each of three sums, all times 1.2, and 3 n H in the bound: A pays for it. The offset has no
/// guard: where it overflows the terms they are infinite, and nothing exceeds them.
template <class Float, class Format = FloatFormat<Float>>
Sign plane(const Plane<Float>& plane, const Point3<Float>& p) {
  using B = Bounds<Float, Format>;
  const Vector3<Float>& n = plane.normal;
  const Float x = n.x * p.x, y = n.y * p.y, z = n.z * p.z;
  const Float value = x + y + z + plane.offset;
  const Float terms = extent<Float, Format>(x, y, z) + Format::magnitude(plane.offset);
  const Float of_normal = extent<Float, Format>(n.x, n.y, n.z), of_point = extent<Float, Format>(p.x, p.y, p.z);
  const int known = Format::magnitude(value) > B::template relative<6, 32>() * terms + B::absolute();
  const int guarded = of_normal + of_point <= B::high(), directed = of_normal > Float();
  if ((known & guarded & directed) == 0) [[unlikely]]  // one branch
    return Sign::unknown;
  return value > Float() ? Sign::positive : Sign::negative;
}

}  // namespace touchstone::robust::filters
