// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/hard_case.h"
#include "catalogue/families/meshes/convex_pair_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/triangle_draws.h"
#include "geometry/penetration.h"

/// Points, segments and triangles as cores of round solids, drawn from a draw stream.
namespace touchstone::catalogue {

/// Two cores with radii.
using RoundCores = std::tuple<Meshd, Meshd, double, double>;

inline Meshd simplex(const Point3d& p) { return {{p}, {}, {}}; }
inline Meshd simplex(const Segment3d& s) { return {{s.a, s.b}, {}, {}}; }
inline Meshd simplex(const Triangle3d& t) { return {{t.a, t.b, t.c}, {}, {}}; }

/// It has one to three vertices, drawn by point(draws).
template <class Draw>
Meshd simplex_of(DrawStream& c, const Draw& point) {
  Meshd found;
  for (auto k = 1 + c.below(3); k > 0; --k) found.vertices.push_back(point(c));
  return found;
}

/// In either order, with radii that are often 0.
inline RoundCores round_cores(DrawStream& c, const Meshd& a, const Meshd& b) {
  const bool exchanged = c.coin();
  const double r = up_to(c, 2), s = up_to(c, 2);
  return exchanged ? RoundCores{b, a, r, s} : RoundCores{a, b, r, s};
}

inline void add_round_cores(HardCases<RoundCores>& add) {
  add("balls", [](DrawStream& c) -> RoundCores {
    // Around one center, or an integer apart; the radii bridge that, or nearly.
    const Step step = integer_step(c);
    const Radii radii = reaching_radii(c, step.length);
    const Point3d p = lattice_point_in_space(c, 16);
    return {simplex(p), simplex(along(p, up_to(c, 1), step.displacement)), radii.r, radii.s};
  });
  add("crossing_capsules", [](DrawStream& c) -> RoundCores {
    const Point3d p = lattice_point_in_space(c, 12);
    const Vector3d u = lattice_normal(c, 12), v = lattice_normal(c, 12);
    const Segment3d a = segment_through(c, p, u), b = segment_through(c, p, v);
    return round_cores(c, simplex(a), simplex(b));
  });
  add("parallel_capsules", [](DrawStream& c) -> RoundCores {
    // Side by side, or on one line, where they overlap, touch or are apart; as short as a point.
    const LatticeLine line = LatticeLine::of(c);
    const double i = small_integer(c, 3), j = small_integer(c, 3), k = small_integer(c, 3), l = small_integer(c, 3);
    Meshd b = simplex(line.between(k, l));
    if (c.coin()) b = shifted(b, line.across);
    return round_cores(c, simplex(line.between(i, j)), b);
  });
  add("askew_capsules", [](DrawStream& c) -> RoundCores {
    // Nearly on one line, and a little above each other.
    const double askew = small_integer(c, 1) * 0x1p-40, height = small_integer(c, 1) * 0x1p-50;
    const double from = small_integer(c, 3), side = small_integer(c, 1) * 0x1p-40;
    return round_cores(c, simplex(Segment3d{{-7, 0, 0}, {9, 0, 0}}),
                       simplex(Segment3d{{from - 5, side, height}, {from + 3, askew, height}}));
  });
  add("along_axes", [](DrawStream& c) -> RoundCores {
    // In a plane or on a line along axes.
    const bool x = c.coin(), y = c.coin(), z = c.coin();
    const auto point = [x, y, z](DrawStream& d) -> Point3d {
      const auto [i, j, k] = beside(Point3d{0, 0, 0}, d, 2);
      return {x ? i : 1, y ? j : 1, z ? k : 1};
    };
    const Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    return round_cores(c, a, b);
  });
  add("on_one_line", [](DrawStream& c) -> RoundCores {
    const LatticePlane plane = LatticePlane::of(c);
    const auto point = [&plane](DrawStream& d) { return plane.on_line(d); };
    const Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    return round_cores(c, a, b);
  });
  add("in_one_plane", [](DrawStream& c) -> RoundCores {
    // A ball or a capsule in a triangle's plane, two triangles in one.
    const LatticePlane plane = LatticePlane::of(c);
    const Meshd a = simplex(plane.triangle(c)), b = simplex_of(c, [&plane](DrawStream&d) { return plane.point(d); });
    return round_cores(c, a, b);
  });
  add("through_triangle", [](DrawStream& c) -> RoundCores {
    const LatticePlane plane = LatticePlane::of(c);
    const Meshd a = simplex(plane.triangle(c));
    const Point3d p = plane.point(c);
    const Vector3d v = c.coin() ? plane.u : lattice_normal(c, 12);
    Meshd b = simplex(segment_through(c, p, v));
    if (c.coin()) b.vertices.push_back(lattice_point_in_space(c, 12));
    return round_cores(c, a, b);
  });
  add("small_simplices", [](DrawStream& c) -> RoundCores {
    const Meshd a = simplex_of(c, small_lattice_point), b = simplex_of(c, small_lattice_point);
    return round_cores(c, a, b);
  });
  add("simplex_and_solid", [](DrawStream& c) -> RoundCores {
    // In it, on its surface, or some steps away.
    const Meshd solid = lattice_polyhedron(c);
    const double steps = small_integer(c, 1);
    const Vector3d way = steps * lattice_normal(c, 3);
    const Meshd core = simplex_of(
        c, [&solid](DrawStream& d) { return d.coin() ? between_vertices(solid, d) : on_a_face_plane(solid, d); });
    return round_cores(c, solid, shifted(core, way));
  });
  add("repeated_in_solid", [](DrawStream& c) -> RoundCores {
    // Vertices that coincide, and what is as deep in several directions.
    const Meshd solid = lattice_polyhedron(c);
    const Point3d p = between_vertices(solid, c), q = solid.vertices[0];
    const Meshd core = simplex_of(c, [&](DrawStream& d) { return d.coin() ? p : q; });
    const Meshd repeated = with_repeated_vertex(solid, c);
    return round_cores(c, repeated, core);
  });
  add("cores_an_ulp_apart", [](DrawStream& c) -> RoundCores {
    const LatticePlane plane = LatticePlane::of(c, 4);
    const auto point = [&plane](DrawStream& d) { return plane.point(d, 1) + Vector3d{0x1p20, 0, 0}; };
    Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    a.vertices[0] = beside_by_ulps(a.vertices[0], c), b.vertices[0] = beside_by_ulps(b.vertices[0], c);
    return round_cores(c, a, b);
  });
  add("rounded_cores", [](DrawStream& c) -> RoundCores {
    // A corner of b in a's triangle or on its edge, as far as doubles can tell.
    const Triangle3d a = triangle_of(c, ordinary_point_in_space);
    const Point3d p = c.coin() ? rounded_onto(a, c) : a.a + ordinary(c) * (a.b - a.a);
    const Segment3d through{p, ordinary_point_in_space(c)};
    const Meshd first = c.coin() ? simplex(a) : simplex(Segment3d{a.a, a.b});
    return round_cores(c, first, simplex(through));
  });
  add("stretched_cores", [](DrawStream& c) -> RoundCores {
    const LatticePlane plane = LatticePlane::of(c);
    const auto point = [&plane](DrawStream& d) { return d.coin() ? plane.point(d) : lattice_point_in_space(d, 4); };
    Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    Stretch{c, {0, 60, 500, 1010, -170, -900}}(a, b);
    return round_cores(c, a, b);
  });
  add("typed_cores", [](DrawStream& c) -> RoundCores {
    const Meshd a = simplex_of(c, typed_point), b = simplex_of(c, typed_point);
    const double r = std::fabs(typed(c)), s = std::fabs(typed(c));
    return {a, b, r, s};
  });
  add("subnormal_cores", [](DrawStream& c) -> RoundCores {
    const auto point = [](DrawStream& d) { return subnormal_point(d); };
    const Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    const double r = std::fabs(subnormal(c)), s = std::fabs(subnormal(c));
    return {a, b, r, s};
  });
  add("cores_of_full_range", [](DrawStream& c) -> RoundCores {
    const Meshd a = simplex_of(c, point_of_full_range), b = simplex_of(c, point_of_full_range);
    const double r = std::fabs(of_full_range(c)), s = std::fabs(of_full_range(c));
    return {a, b, r, s};
  });
  add("zero_cores", [](DrawStream& c) -> RoundCores {
    // 0 and -0, and the axes.
    const auto point = [](DrawStream& d) -> Point3d {
      const auto [x, y, z] = zero_point(d);
      const double far = small_integer(d, 1);
      return {x, d.coin() ? y : far, z};
    };
    const Meshd a = simplex_of(c, point), b = simplex_of(c, point);
    const double r = zero(c), s = zero(c);
    return {a, b, r, s};
  });
  add("vertices_without_faces", [](DrawStream& c) -> RoundCores {
    // None, and more than three, are no core.
    Meshd b;
    for (auto k = c.below(6); k > 0; --k) b.vertices.push_back(small_lattice_point(c));
    const Meshd a = simplex_of(c, small_lattice_point);
    return round_cores(c, a, b);
  });
  add("cores_of_negative_radius", [](DrawStream& c) -> RoundCores {
    const Meshd a = simplex_of(c, small_lattice_point), b = simplex_of(c, small_lattice_point);
    const double r = small_integer(c, 2), s = small_integer(c, 2);
    return {a, b, r, s};
  });
}

}  // namespace touchstone::catalogue
