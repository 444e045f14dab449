// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/meshes/convex_pair_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/convex_distance.h"
#include "oracle/mixed/convex_distance.h"
#include "reference/mixed/convex_distance.h"
#include "robust/mixed/convex_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct convex_distance : signatures::convex_distance {
  TOUCHSTONE_MODULES(convex_distance)
  TOUCHSTONE_PREPARED(convex_distance, ConvexSolid)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "48-50, 53-54",
      .question = "Which points of two convex polyhedra are nearest to each other, and how far is it?",
      .kind = Kind::measure,
      .fields = {"a", "b"},
      .ulps = 60,
      .cost = 300,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::linearithmic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", [](DrawStream& c) -> Question {
      const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      return {a, shifted(b, 12.0 * lattice_normal(c, 4))};
    });
    add("feature_to_feature", [](DrawStream& c) -> Question { return aimed(c, one_to(c, 4)); });
    add("touching", [](DrawStream& c) -> Question { return aimed(c, 0); });
    add("an_ulp_apart", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 0);
      const double far = small_integer(c, 1), side = small_integer(c, 1);
      for (Meshd* mesh : {&a, &b})
        for (Point3d& p : mesh->vertices) p.x += std::ldexp(far, 20);
      for (Point3d& p : b.vertices) p.x = std::nextafter(p.x, p.x + side);
      return {a, b};
    });
    add("reflected", [](DrawStream& c) -> Question {
      // Each face of one is parallel to one of the other: two of them face each other, aside by a little.
      const Meshd a = lattice_polyhedron(c);
      const auto [p, out] = corner_of_face(a, c);
      const Vector3d aside = lattice_across(c, out);
      return {a, reflected(a, p + 0.5 * (up_to(c, 2) * out + aside))};
    });
    add("parallel_edges", [](DrawStream& c) -> Question {
      // Roofs whose ridges face each other; one may be a little askew.
      const double from = small_integer(c), to = small_integer(c), height = up_to(c, 3);
      const double side = small_integer(c, 1), askew = c.coin() ? 0x1p-40 * side : side;
      return {roof({0, 0, 0}, {8, 0, 0}, -8), roof({from, 0, height}, {to + 9, askew, height}, 8)};
    });
    add("nested", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c);
      const Meshd b = lattice_polyhedron(c);
      for (Point3d& p : a.vertices) p = {8 * p.x - 40, 8 * p.y - 40, 8 * p.z - 40};
      return in_either_order(c, b, a);
    });
    add("flat_vertices", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 1);
      return {with_flat_vertex(a, c), with_flat_vertex(b, c)};
    });
    add("repeated_vertices", [](DrawStream& c) -> Question {
      // Vertices of no face where others are, with an index below or above these.
      const auto [a, b] = c.coin() ? aimed(c, 1) : Question{lattice_polyhedron(c), lattice_polyhedron(c)};
      return {with_repeated_vertex(a, c), with_repeated_vertex(shifted(b, {0, 0, 24}), c)};
    });
    add("needles", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 1);
      const double length = scaled_up(c, 8, 60), other = scaled_up(c, 8, 60);
      for (Point3d& p : a.vertices) p.x = p.x * length;
      for (Point3d& p : b.vertices) p.y = p.y * other;
      return {a, b};
    });
    add("stretched", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 1);
      Stretch{c, {0, 60, 500, 1010, -170, -900}}(a, b);
      return {a, b};
    });
    add("mapped", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 1);
      map_linearly(c, a, b);
      return {a, b};
    });
    add("rounded", [](DrawStream& c) -> Question {
      // A corner of b where one of a is, as far as doubles can tell; or anywhere.
      const Meshd a = tetrahedron_of(c, ordinary_point_in_space), b = tetrahedron_of(c, ordinary_point_in_space);
      return {a, c.coin() ? b : shifted(b, a.vertices[0] - b.vertices[0])};
    });
    add("full_mantissa", [](DrawStream& c) -> Question {
      // One corner of each in the plane of a face of the other.
      const LongPlane plane = LongPlane::of(c);
      const auto on = [&] { return plane.point(c); };
      const auto off = [&] { return ordinary_point_in_space(c); };
      const Point3d p = on(), q = on(), r = on(), s = on(), t = on(), u = off();
      return {tetrahedron_over({p, q, r, u}), tetrahedron_over({s, t, off(), off()})};
    });
    add("rounding", [](DrawStream& c) -> Question {
      // The foot of b's corner on a diagonal edge is half an odd step along: x is halfway between two doubles.
      const double x = halfway_number(c), odd = 1 + 2 * up_to(c, 7);
      const Point3d end{x + odd, 0, hair(c)};
      return {tetrahedron_over({{{x, 0, 0}, {x + 64, 64, 0}, {x, 64, 32}, {x, 64, -32}}}),
              tetrahedron_over({{end, {end.x + 8, -8, 4}, {end.x + 8, -8, -4}, {end.x + 16, -8, 0}}})};
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      const Point3d end{step.x, step.y, -hair(c)};
      return {tetrahedron_over({{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}, {0, 0, 4}}}),
              tetrahedron_over({{end, {2 * step.x, step.y, 0}, {step.x, 2 * step.y, 0}, {step.x, step.y, -4}}})};
    });
    add("far_apart", [](DrawStream& c) -> Question {
      // One of them is as large as its distance.
      const Meshd a = lattice_polyhedron(c);
      const Vector3d off = 96.0 * lattice_normal(c, 2);
      Meshd b = shifted(lattice_polyhedron(c), off);
      const int places = c.coin() ? 1000 : 60;
      for (Point3d& p : b.vertices) p = scaled(p, places);
      return in_either_order(c, a, b);
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      return {tetrahedron_of(c, typed_point), tetrahedron_of(c, typed_point)};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 1);
      for (Meshd* mesh : {&a, &b})
        for (Point3d& p : mesh->vertices) p = scaled(p, -1074);
      return {a, b};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {tetrahedron_of(c, point_of_full_range), tetrahedron_of(c, point_of_full_range)};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), q = zero_point(c);
      const double far = small_integer(c, 2);
      const Meshd a = tetrahedron_over({{p, {-1, q.y, q.z}, {q.x, -1, p.z}, {p.x, p.y, -1}}});
      return {a, reflected(a, {far / 2, p.y, p.z})};
    });
    add("broken", [](DrawStream& c) -> Question {
      const auto [a, b] = aimed(c, 1);
      return c.coin() ? Question{a, broken(b, c)} : Question{broken(a, c), b};
    });
    add.unscaled("late_vertices", [](DrawStream& c) -> Question {
      const Meshd a = with_late_corners(c), b = with_late_corners(c);
      return {a, shifted(b, 2048.0 * lattice_normal(c, 4))};
    });
    add.unscaled("named_mesh", [](DrawStream& c) -> Question {
      const Meshd &a = named_mesh(c), b = tetrahedron_over({{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}});
      const Point3d p = on_a_face_plane(a, c), to = p + 12.0 * lattice_normal(c, 3);
      return in_either_order(c, a, shifted(b, to - Point3d{0, 0, 0}));
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd a = convex_solid_of_polygons(c), b = lattice_polyhedron(c);
      return {c.one_in(6) ? with_broken_polygons(a, c) : a, shifted(b, 12.0 * lattice_normal(c, 4))};
    });
  }

  static void repair(Question& question) {
    make_tetrahedron(std::get<0>(question)), make_tetrahedron(std::get<1>(question));
  }

  /// A tetrahedron of size 4, its top on a grid, below another, of which a corner is on a grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd a{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2 * x, 2 * y, 2 * (z + 1)}}, {}};
    Meshd b{{{2 * u, 2 * v, 2 * w}, {8, 4, 8}, {4, 8, 8}, {4, 4, 12}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b};
  }

  /// A corner of a touches an edge of b: moves that corner.
  static Question map_centre() {
    Meshd a{{{12, 0, 0}, {-12, 0, 0}, {0, -12, 0}, {0, 0, -12}}, {}},
        b{{{12, -6, 0}, {12, 6, 0}, {24, 0, 0}, {12, 0, 12}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static Hooks<convex_distance> hooks() {
    return {.as_open_sets = apart_if_touching<convex_distance>,
            .as_near = as_near_to_answer<convex_distance>,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes}};
  }
};

}  // namespace touchstone::catalogue::rows
