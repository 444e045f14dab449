// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "robust/kernel/lattice.h"
#include "robust/kernel/plane.h"
#include "robust/kernel/staged.h"

/// Whether a line meets a triangle, by exact signs of determinants.
namespace touchstone::robust::kernel {

/// Two points, or a point and a vector, and a triangle on one lattice.
struct LineAndTriangle {
  Point3<std::int64_t> p, q;
  Triangle3<std::int64_t> triangle;
};
template <class P, class Q>
std::optional<LineAndTriangle> on_lattice(const P& p, const Q& q, const Triangle3d& triangle) {
  const auto& [a, b, c] = triangle;
  const auto lattice = lattice_of(p.x, p.y, p.z, q.x, q.y, q.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  if (!lattice) return std::nullopt;
  const auto& n = lattice->at;
  const auto point = [&n](std::size_t i) { return Point3<std::int64_t>{n[i], n[i + 1], n[i + 2]}; };
  return LineAndTriangle{point(0), point(3), {point(6), point(9), point(12)}};
}

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
