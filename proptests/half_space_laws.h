// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proptests/space_laws.h"

/// Laws of every convex solid and the half-space behind a plane, in the types of the file's `Row`; flat(solid) tells
/// that it has no interior.
#define HALF_SPACE_LAWS(op, flat)                                                                                 \
  TEST_CASE(op ": the plane's equation times a power of two, or times 3 on the lattice, is the same plane") {     \
    law<Row>("the same plane", any_equation_of_the_plane<1>);                                                     \
  }                                                                                                               \
  LAW(op ": what is disjoint from the back overlaps the front, and what has no interior overlaps neither", solid, \
      plane) {                                                                                                    \
    const Contact front = ask(Row::Question{solid, {-1.0 * plane.normal, -plane.offset}});                        \
    return std::max(ask(asked), front) == (flat(solid) ? Contact::touching : Contact::overlapping);               \
  }

namespace touchstone::proptests {

inline constexpr Plane3d ground{{0, 1, 0}, 0};

/// What sphere_plane's contract promises of the formula for balls of one radius around these points, by the least of
/// the heights; `inside`: the truth where it reaches behind the plane.
inline bool keeps_contract_over_plane(const std::vector<Point3d>& centers, double radius, const Plane3d& plane,
                                      Contact answer, Contact truth) {
  const double q = dot(plane.normal, plane.normal), reach = radius * std::sqrt(q);
  if (!(q >= 0x1p-960 && q <= 0x1p960) || !finite(reach)) return true;
  bool apart = true;
  for (const Point3d& center : centers) {
    const HeightBound e(plane, center);
    if (e.overflow) return true;
    const Rational gap = exact(e.computed) - exact(reach);
    if (abs(gap) <= e.error + 5 * unit() * exact(reach) + power_of_two(-1074)) return true;
    apart = apart && gap > 0;
  }
  const Contact inside = radius == 0 ? Contact::touching : Contact::overlapping;
  return answer == (apart ? Contact::disjoint : Contact::overlapping) && truth == (apart ? Contact::disjoint : inside);
}

}  // namespace touchstone::proptests
