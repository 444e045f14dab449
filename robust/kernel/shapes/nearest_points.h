// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "geometry/answers.h"
#include "geometry/closest.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"
#include "robust/kernel/shapes/points_in_space.h"

/// The nearest points of points, segments, triangles and boxes of space, by cases, in integers. Shapes without length
/// or area are cases like others. The plane is z = 0.
namespace touchstone::robust::kernel {

using IntegerPoint = Point3<mpz_class>;

/// A point: n / d, d > 0.
struct QuotientPoint {
  IntegerPoint n;
  mpz_class d;
};
struct QuotientPair {
  QuotientPoint on_a, on_b;
};
/// n / d, d > 0.
struct Quotient {
  mpz_class n, d;
};
QuotientPoint nearest_on_segment(const IntegerPoint& p, const Segment3<mpz_class>& segment);
QuotientPoint nearest_on_triangle(const IntegerPoint& p, const Triangle3<mpz_class>& triangle);
/// All center + r u + s v + t w with r, s and t in [-1, 1], u, v and w being the half axes. Each has a direction; these
/// are linearly independent, and half axes may be 0.
struct IntegerBox {
  IntegerPoint center;
  std::array<Vector3<mpz_class>, 3> half_axes, directions;
};
/// A point of the box is the nearest to itself.
QuotientPoint nearest_in_box(const IntegerPoint& p, const IntegerBox& box);
/// Among several nearest pairs the one with the least parameter on a.
QuotientPair nearest_pair(const Segment3<mpz_class>& a, const Segment3<mpz_class>& b);

Quotient squared_distance(const QuotientPoint& p, const QuotientPoint& q);
/// 0 if they have a common point.
Quotient squared_distance(const Segment3<mpz_class>& segment, const IntegerBox& box);
Quotient squared_distance(const Segment3<mpz_class>& segment, const Triangle3<mpz_class>& triangle);

/// The contact of two shapes at that distance, one or both of them grown by a radius; `reach` is the sum of the radii.
/// `interiors`: no radius is 0.
Contact contact(const Quotient& square, const mpz_class& reach, bool interiors);

inline Point3d in_space(const Point2d& p) { return {p.x, p.y, 0}; }
inline const Point3d& in_space(const Point3d& p) { return p; }
inline Point3d in_space(const Vector3d& v) { return {v.x, v.y, v.z}; }
inline Segment3d in_space(const Segment2d& s) { return {in_space(s.a), in_space(s.b)}; }

/// Points of the plane or of space over one power of two.
template <class... Points>
ScaledPoints<mpz_class> integer_points(const Points&... p) {
  return integers_of(Polygon3d{{in_space(p)...}});
}

/// The box whose center and independent half axes are these points, one after the other.
inline IntegerBox box_of(const std::vector<IntegerPoint>& at, std::size_t center) {
  const auto axis = [&](std::size_t k) { return at[center + k] - IntegerPoint{0, 0, 0}; };
  const std::array half_axes{axis(1), axis(2), axis(3)};
  return {at[center], half_axes, half_axes};
}
/// Twice a box along the axes, so that its center is an integer; it may be flat.
inline IntegerBox doubled_box(const IntegerPoint& min, const IntegerPoint& max) {
  const auto along = [](const mpz_class& x, const mpz_class& y, const mpz_class& z) {
    return std::array<Vector3<mpz_class>, 3>{{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
  };
  return {max + (min - IntegerPoint{0, 0, 0}), along(max.x - min.x, max.y - min.y, max.z - min.z), along(1, 1, 1)};
}
inline IntegerPoint doubled(const IntegerPoint& p) { return p + (p - IntegerPoint{0, 0, 0}); }

/// A point in units of the input times 2^exponent, each number rounded once.
Point3d rounded(const QuotientPoint& p, int exponent);
ClosestPoint3<double> closest_point(const IntegerPoint& from, const QuotientPoint& nearest, int exponent);
ClosestPair3<double> closest_pair(const QuotientPair& pair, int exponent);

inline Point2d in_plane(const Point3d& p) { return {p.x, p.y}; }
inline ClosestPoint2<double> in_plane(const ClosestPoint3<double>& found) {
  return {in_plane(found.point), found.squared_distance, found.distance};
}
inline ClosestPair2<double> in_plane(const ClosestPair3<double>& found) {
  return {in_plane(found.on_a), in_plane(found.on_b), found.squared_distance, found.distance};
}
template <class Answer>
auto in_plane(const Perhaps<Answer>& found) -> Perhaps<decltype(in_plane(*found))> {
  if (!found) return std::nullopt;
  return in_plane(*found);
}

}  // namespace touchstone::robust::kernel
