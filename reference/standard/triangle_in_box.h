// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"

namespace touchstone::reference::standard {

/// A triangle and a box by separating axes, every vertex seen from the box's center (Akenine-Moeller, Fast 3D
/// triangle-box overlap testing, 2001): edges and normal are differences of what was moved there. Contract:
/// reference/mixed/triangle_aabb.h, as right as which it is in exact arithmetic.
template <class Real>
Contact triangle_aabb(const Triangle3<Real>& triangle, const Aabb3<Real>& aabb) {
  const auto half = [](const Real& x) { return Real(x * Real(Real(1) / Real(2))); };
  const auto& [min, max] = aabb;
  const Point3<Real> center{half(Real(min.x + max.x)), half(Real(min.y + max.y)), half(Real(min.z + max.z))};
  const Vector3<Real> h{half(Real(max.x - min.x)), half(Real(max.y - min.y)), half(Real(max.z - min.z))};
  const Vector3<Real> corners[] = {triangle.a - center, triangle.b - center, triangle.c - center};
  const Vector3<Real> edges[] = {corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  const auto size = [](const Real& x) { return x < Real(0) ? Real(-x) : x; };
  bool touching = false;
  const auto separates = [&](const Real& p, const Real& q, const Real& r, const Real& reach) {
    Real least = q < p ? q : p, greatest = q < p ? p : q;
    if (r < least) least = r;
    else if (!(r < greatest)) greatest = r;
    if (least == reach || greatest == Real(-reach)) touching = true;
    return least > reach || greatest < Real(-reach);
  };
  const auto across = [&](Real Vector3<Real>::*y, Real Vector3<Real>::*z) {
    return std::any_of(std::begin(edges), std::end(edges), [&](const Vector3<Real>& e) {
      const auto at = [&](const Vector3<Real>& v) { return Real(e.*z * v.*y - e.*y * v.*z); };
      return separates(at(corners[0]), at(corners[1]), at(corners[2]), Real(size(e.*z) * h.*y + size(e.*y) * h.*z));
    });
  };
  using V = Vector3<Real>;
  if (across(&V::y, &V::z) || across(&V::z, &V::x) || across(&V::x, &V::y)) return Contact::disjoint;
  for (const auto axis : {&V::x, &V::y, &V::z})
    if (separates(corners[0].*axis, corners[1].*axis, corners[2].*axis, h.*axis)) return Contact::disjoint;
  const Vector3<Real> n = cross(edges[0], edges[1]);
  const Real at = dot(n, corners[0]);
  if (separates(at, at, at, Real(Real(size(n.x) * h.x + size(n.y) * h.y) + size(n.z) * h.z))) return Contact::disjoint;
  return touching ? Contact::touching : Contact::overlapping;
}

}  // namespace touchstone::reference::standard
