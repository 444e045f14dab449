// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <utility>

#include "catalogue/families/coplanar_draws.h"
#include "catalogue/families/hard_case.h"
#include "catalogue/families/triangle_draws.h"

/// Two triangles in space, drawn from a draw stream.
namespace touchstone::catalogue {

using TrianglePair = std::tuple<Triangle3d, Triangle3d>;

/// Around one point, or near it, in two planes.
inline TrianglePair crossing_triangles(DrawStream& c) {
  const LatticePlane plane = LatticePlane::of(c), other = LatticePlane::of(c);
  return {plane.triangle(c), LatticePlane{plane.origin, other.u, other.v}.triangle(c)};
}

/// Edges along one line, which may share all of it, a part, an end or nothing.
inline TrianglePair edges_on_a_line(DrawStream& c) {
  const LatticePlane edge = LatticePlane::of(c);
  const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3), l = small_integer(c, 3);
  const Point3d p = lattice_point_in_space(c);
  return {{edge.at(i, 0), edge.at(j, 0), p}, {edge.at(k, 0), lattice_point_in_space(c), edge.at(l, 0)}};
}

/// A corner on a face, an edge or a corner, or near them in their plane.
inline TrianglePair corner_on_triangle(DrawStream& c) {
  const LatticePlane plane = LatticePlane::of(c);
  const Triangle3d t = plane.triangle(c);
  const Point3d p = plane.point(c);
  return {t, {lattice_point_in_space(c), p, lattice_point_in_space(c)}};
}

inline TrianglePair edge_on_edge(DrawStream& c) {
  const LatticePlane cross = LatticePlane::of(c);
  const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3), l = small_integer(c, 3);
  const Point3d p = lattice_point_in_space(c);
  return {{cross.at(i, 0), cross.at(j, 0), p}, {cross.at(0, k), cross.at(0, l), lattice_point_in_space(c)}};
}

/// Thousands of millions long, a few units wide, across each other.
inline TrianglePair crossing_needles(DrawStream& c) {
  const double length = power_of_two(c, 30, 41);
  const auto unit = [&c] { return small_integer(c, 3); };
  const double ay = unit(), az = unit(), by = unit(), bz = unit(), cx = unit(), cz = unit();
  const Triangle3d t{{-length, ay, az}, {length, by, 0}, {length, 0, bz}};
  return {t, {{cx, -length, cz}, {unit(), length, 0}, {0, length, unit()}}};
}

/// One corner rounded onto the plane of the other triangle.
inline TrianglePair corner_rounded_onto(DrawStream& c) {
  const Triangle3d t = triangle_of(c, ordinary_point_in_space);
  return {t, {rounded_onto(t, c), ordinary_point_in_space(c), ordinary_point_in_space(c)}};
}

/// In one plane, whose points have 53 digits.
inline TrianglePair long_coplanar(DrawStream& c) {
  const LongPlane plane = LongPlane::of(c);
  const auto point = [&plane](DrawStream& draws) { return plane.point(draws); };
  return {triangle_of(c, point), triangle_of(c, point)};
}

inline Triangle3d shifted(const Triangle3d& t, const Vector3d& by) { return {t.a + by, t.b + by, t.c + by}; }

/// The second a few steps away from where it meets the first, or there.
template <auto draw>
TrianglePair moved_apart(DrawStream& c) {
  const auto [a, b] = draw(c);
  const double steps = up_to(c, 2);
  return {a, shifted(b, steps * lattice_normal(c, 3))};
}

/// A corner, an edge or a face over a face, its edges and corners, or next to it; the rest is higher.
inline TrianglePair triangle_over_face(DrawStream& c) {
  const LatticePlane plane = LatticePlane::of(c, 6);
  const Vector3d normal = cross(plane.u, plane.v);
  const double height = up_to(c, 2);
  const auto corner = [&](double more) { return plane.point(c) + (height + more) * normal; };
  const Point3d p = corner(0), q = corner(up_to(c, 1)), r = corner(up_to(c, 2));
  const Triangle3d t = plane.triangle(c);
  return in_either_order(c, t, in_some_order({p, q, r}, c));
}

/// Across each other, or side by side, one perhaps a little askew; the other corners are farther apart.
inline TrianglePair edges_over_each_other(DrawStream& c) {
  const LatticePlane plane = LatticePlane::of(c, 6);
  const Vector3d normal = cross(plane.u, plane.v), off = up_to(c, 2) * normal;
  const bool across = c.coin();
  const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3), l = small_integer(c, 3);
  const double askew = small_integer(c, 1) * 0x1p-30;
  const double down = one_to(c, 3), up = one_to(c, 5);
  const Point3d below = plane.point(c) + -down * normal, above = plane.point(c) + up * normal;
  const Point3d p = across ? plane.at(0, k) : plane.at(k, 0), q = across ? plane.at(0, l) : plane.at(l, askew);
  return {in_some_order({plane.at(i, 0), plane.at(j, 0), below}, c), in_some_order({p + off, q + off, above}, c)};
}

/// A segment or a point, and any triangle of its plane, or next to that.
inline TrianglePair triangles_without_area(DrawStream& c) {
  const LatticePlane plane = LatticePlane::of(c, 6);
  const Point3d p = plane.point(c);
  const Triangle3d thin = c.one_in(3) ? Triangle3d{p, p, p} : plane.triangle_without_area(c);
  const double steps = up_to(c, 1);
  const Vector3d off = steps * lattice_normal(c, 6);
  return in_either_order(c, thin, shifted(c.coin() ? plane.triangle(c) : plane.triangle_without_area(c), off));
}

template <auto other>
TrianglePair coplanar_triangles(DrawStream& c) {
  CoplanarDraws draws(c);
  const Triangle3d t = draws.triangle();
  return in_either_order(c, t, (draws.*other)());
}

}  // namespace touchstone::catalogue
