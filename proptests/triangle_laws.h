// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "proptests/closest_laws.h"

/// What the tests of triangles in space share.
namespace touchstone::proptests {

/// The sum of the magnitudes of the six products of E at p, and E as computed.
struct SideBound {
  double computed;
  bool overflow;
  Rational error;

  SideBound(const Triangle3d& t, const Point3d& p)
      : SideBound(t, p - t.a, {gap(p.x, t.a.x), gap(p.y, t.a.y), gap(p.z, t.a.z)}) {}
  /// Of a displacement instead of p - a, which is not rounded.
  SideBound(const Triangle3d& t, const Vector3d& d) : SideBound(t, d, {size(d.x), size(d.y), size(d.z)}) {}

 private:
  static Rational gap(double a, double b) { return Rational(abs(exact(a) - exact(b))); }

  SideBound(const Triangle3d& t, const Vector3d& d, const Vector3<Rational>& sizes) {
    const Vector3d v = t.b - t.a, w = t.c - t.a, n = cross(v, w);
    computed = dot(n, d);
    overflow = !finite(v.x, v.y, v.z, w.x, w.y, w.z, d.x, d.y, d.z) || !finite(v.y * w.z, v.z * w.y, v.z * w.x) ||
               !finite(v.x * w.z, v.x * w.y, v.y * w.x, n.x, n.y, n.z) || !finite(n.x * d.x, n.y * d.y, n.z * d.z) ||
               !finite(n.x * d.x + n.y * d.y, computed);
    const Rational vx = gap(t.b.x, t.a.x), vy = gap(t.b.y, t.a.y), vz = gap(t.b.z, t.a.z), wx = gap(t.c.x, t.a.x),
                   wy = gap(t.c.y, t.a.y), wz = gap(t.c.z, t.a.z);
    const auto& [dx, dy, dz] = sizes;
    const Rational products = (vy * wz + vz * wy) * dx + (vz * wx + vx * wz) * dy + (vx * wy + vy * wx) * dz;
    error = 8 * (1 + 4 * unit()) * unit() * products + power_of_two(-1073) * (dx + dy + dz + 2);
  }
};

/// By the contract of closest_point_on_triangle: whether the formula is certain to find the corner a nearest to p.
inline bool certainly_beyond_a(const Point3d& p, const Triangle3d& t) {
  const Rational u = unit();
  const auto beyond = [&](const Point3d& end) {
    if (!finite(dot(end - t.a, p - t.a))) return false;
    const ExactProducts products(exact_between(t.a, end), exact_between(t.a, p));
    return products.sum < -((5 + 11 * u) * u * products.sizes + power_of_two(-1073));
  };
  return beyond(t.b) && beyond(t.c);
}

/// Whether a point is farther beside the triangle's plane than the bound of E, the sixfold volume of a tetrahedron.
inline bool certainly_beside(const Triangle3d& t, const Point3d& p) {
  if (!finite(dot(cross(t.b - t.a, t.c - t.a), p - t.a))) return false;
  const Point3<Rational> a = exact_point(t.a), b = exact_point(t.b);
  const Rational volume = dot(cross(b - a, exact_point(t.c) - a), exact_point(p) - a);
  return abs(volume) > SideBound(t, p).error;
}

}  // namespace touchstone::proptests
