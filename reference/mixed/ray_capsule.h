// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "reference/mixed/ray_sphere.h"

namespace touchstone::reference {

/// The least and the greatest t at which the line from + t v enters and leaves the balls around both ends of a capsule,
/// and its cylinder between them.
template <class Real>
RootsOfSphere<Real> roots_of_capsule(const Point3<Real>& from, const Vector3<Real>& v, const Capsule3<Real>& capsule) {
  const auto& [a, b] = capsule.segment;
  const Real& r = capsule.radius;
  RootsOfSphere<Real> found;
  bool enters = false, leaves = false;
  const auto enter = [&](const Real& t) {
    if (!enters || t < found.smaller) found.smaller = t;
    enters = true;
  };
  const auto leave = [&](const Real& t) {
    if (!leaves || found.greater < t) found.greater = t;
    leaves = true;
  };
  for (const Point3<Real>* end : {&a, &b}) {
    const RootsOfSphere<Real> ball(from - *end, v, r);
    if (ball.real) enter(ball.smaller), leave(ball.greater);
  }
  const Vector3<Real> p = from - a, w = b - a;
  const Real length = dot(w, w), start = dot(p, w), climb = dot(v, w);
  const RootsOfSphere<Real> side(Real(Real(length * dot(v, v)) - Real(climb * climb)),
                                 Real(Real(2) * Real(Real(length * dot(p, v)) - Real(start * climb))),
                                 Real(Real(length * Real(dot(p, p) - Real(r * r))) - Real(start * start)));
  const auto between = [&](const Real& t) {
    const Real height = Real(start + Real(t * climb));
    return Real(0) <= height && height <= length;
  };
  if (side.real && between(side.smaller)) enter(side.smaller);
  if (side.real && between(side.greater)) leave(side.greater);
  found.real = enters && leaves;
  return found;
}

/// Finds where a ray enters and leaves a capsule, by the quadratic formula for the balls around its ends and for the
/// cylinder between them.
///
/// No page of the deck asks this. The formula is the textbook's for a ray and a cylinder (Ericson, Real-Time Collision
/// Detection, 5.3.7), and that of ray_sphere.h for the balls. With p the displacement from the end a to the origin, w =
/// b - a and L = w . w, the line is as far from the axis as the radius where A t^2 + B t + C = 0, with A = L v . v - (v
/// . w)^2, B = 2 (L p . v - (p . w) (v . w)) and C = L (p . p - r^2) - (p . w)^2. A root t counts if 0 <= (p + t v) . w
/// <= L; those of the balls always do. `none` where nothing counts or the greatest root is negative; otherwise `hit`
/// from the least, or 0 if that is negative, to the greatest.
/// ray, capsule: any unit of length, the same for both; t is in units of the direction's length. Closed sets: the
/// origin and the boundary belong to them, so a tangent ray is a hit, and so is one that slides along the cylinder.
/// first is 0 if the origin is in the capsule. The capsule is solid: a ray that starts inside has met it. A segment of
/// length 0 is valid: the capsule is a ball. So is a radius of 0 (or -0): it is a segment, or a point, and a hit ends
/// where it began, unless the ray runs along it.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("ray.origin[0]", "capsule.segment[0][0]" ...,
/// "finite number"); a direction of length 0 ("ray.direction", "nonzero direction"); a negative radius
/// ("capsule.radius", "radius >= 0"). first and last are infinite if the exact ones are beyond the range of doubles.
///
/// In exact arithmetic the formula is always right: where the ray is parallel to the axis, or this a point, the roots
/// of the cylinder are 0/0, and do not count; entry and exit are then those of the balls.
///
/// Margin: |m - r^2|, m being the least squared distance of the ray from the capsule's segment. 0 if the ray only
/// touches the capsule.
///
/// Rounding (binary64, to nearest, u = 2^-53): nothing is promised of the cylinder, where digits of four lengths may
/// cancel. The balls are computed as in ray_sphere.h. So where that promises a `hit` of the ball of the radius around
/// an end, with roots off by at most e, the relation is `hit`, first is no greater than the ball's first + e, and last
/// no less than its last - e. ulps: 49 roundings behind first and last (one in p, one in w; five in each of L, v . w
/// and p . w; eight more in A, eight in B, ten in C; three in D; root, sum, quotient).
template <class Real>
Passage<Real> ray_capsule(const Ray3<Real>& ray, const Capsule3<Real>& capsule) {
  return passage_of_ray(roots_of_capsule(ray.origin, ray.direction, capsule));
}

}  // namespace touchstone::reference
