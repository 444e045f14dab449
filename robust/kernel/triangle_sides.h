// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "robust/kernel/plane.h"
#include "robust/kernel/staged.h"

/// Whether a line meets a triangle, by exact signs of determinants.
namespace touchstone::robust::kernel {

/// The sign of (v x w) . d, of integers below 2^62: below 2^189.
inline int sign_of_triple(const Vector3<std::int64_t>& v, const Vector3<std::int64_t>& w,
                          const Vector3<std::int64_t>& d) {
  const Int128 x = multiply(v.y, w.z) - multiply(v.z, w.y), y = multiply(v.z, w.x) - multiply(v.x, w.z),
               z = multiply(v.x, w.y) - multiply(v.y, w.x);
  return sign_of(multiply(x, d.x) + multiply(y, d.y) + multiply(z, d.z));
}

/// Of the line from p along d, which crosses the plane of the triangle and certainly has its crossing; touching an edge
/// or a corner is meeting.
inline SegmentTriangleRelation crosses(const Point3<std::int64_t>& p, const Vector3<std::int64_t>& d,
                                       const Triangle3<std::int64_t>& t) {
  const Vector3<std::int64_t> a = t.a - p, b = t.b - p, c = t.c - p;
  const int ab = sign_of_triple(a, b, d), bc = sign_of_triple(b, c, d), ca = sign_of_triple(c, a, d);
  const bool left = ab > 0 || bc > 0 || ca > 0, right = ab < 0 || bc < 0 || ca < 0;
  return left && right ? SegmentTriangleRelation::none : SegmentTriangleRelation::point;
}

}  // namespace touchstone::robust::kernel
