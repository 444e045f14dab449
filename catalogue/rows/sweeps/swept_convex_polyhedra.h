// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "catalogue/draw/motions.h"
#include "catalogue/families/meshes/lattice_hull.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_convex_polyhedra.h"
#include "oracle/sweeps/swept_convex_polyhedra.h"
#include "reference/sweeps/swept_convex_polyhedra.h"
#include "robust/prepared/solid.h"
#include "robust/sweeps/swept_convex_polyhedra.h"

namespace touchstone::catalogue::rows {

struct swept_convex_polyhedra : signatures::swept_convex_polyhedra {
  TOUCHSTONE_STAGED_MODULES(swept_convex_polyhedra)
  TOUCHSTONE_PREPARED(swept_convex_polyhedra, ConvexSolid)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "51, 54",
      .question = "When in a step does a moving convex polyhedron first meet one at rest?",
      .kind = Kind::measure,
      .fields = {"a", "b", "velocity"},
      .ulps = 32,
      .cost = 248,
      .time = {.robust = Growth::cubic, .oracle = Growth::quadratic, .ask = Growth::cubic, .reference = Growth::cubic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", [](DrawStream& c) -> Question {
      // Everything in multiples of 12: features pass in one line, or in one plane.
      const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      return {a, shifted(b, 12.0 * lattice_normal(c, 2)), 12.0 * lattice_normal(c, 2)};
    });
    add("feature_to_feature", [](DrawStream& c) -> Question {
      const double n = up_to(c, 3), d = one_to(c, 4);
      return aimed(c, n, d);
    });
    add("contact_at_end", [](DrawStream& c) -> Question { return aimed(c, 1, 1); });
    add("touching_at_start", [](DrawStream& c) -> Question { return aimed(c, 0, small_integer(c, 2)); });
    add("one_inside", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c);
      const Meshd b = lattice_polyhedron(c);
      for (Point3d& p : a.vertices) p = {8 * p.x - 40, 8 * p.y - 40, 8 * p.z - 40};
      return {a, b, lattice_normal(c, 8)};
    });
    add("mapped", [](DrawStream& c) -> Question {
      auto [a, b, velocity] = aimed(c, 1, 2);
      map_linearly(c, a, b, velocity);
      return {a, b, velocity};
    });
    add("stretched", [](DrawStream& c) -> Question {
      auto [a, b, velocity] = aimed(c, 1, 2);
      Stretch{c}(a, b, velocity);
      return {a, b, velocity};
    });
    add("rounded", [](DrawStream& c) -> Question {
      Meshd a = tetrahedron_of(c, ordinary_point_in_space), b = tetrahedron_of(c, ordinary_point_in_space);
      // A corner of b to which one of a gets at the end, as far as doubles can tell; or anywhere.
      const Vector3d v{4 * ordinary(c), 4 * ordinary(c), 4 * ordinary(c)};
      if (!c.coin()) b = shifted(b, (a.vertices[0] - b.vertices[0]) + v);
      return {a, b, v};
    });
    add("broken", [](DrawStream& c) -> Question {
      auto [a, b, velocity] = aimed(c, 1, 1);
      if (!c.coin()) return {broken(a, c), b, velocity};
      return {a, broken(b, c), velocity};
    });
    add.unscaled("named_mesh", [](DrawStream& c) -> Question {
      const Meshd &a = named_mesh(c), b = small_tetrahedron();
      const Point3d p = on_a_face_plane(a, c);
      const Vector3d w = 12.0 * lattice_normal(c, 3);
      return {a, shifted(b, p + 2.0 * w - Point3d{0, 0, 0}), one_to(c, 4) * w};
    });
    add.unscaled("named_mesh_at_rest", [](DrawStream& c) -> Question {
      const Meshd a = small_tetrahedron(), &b = named_mesh(c);
      const Point3d p = on_a_face_plane(b, c);
      const Vector3d w = 12.0 * lattice_normal(c, 3);
      return {shifted(a, p + -2.0 * w - Point3d{0, 0, 0}), b, one_to(c, 4) * w};
    });
    add.unscaled("huge_or_tiny_boxes", [](DrawStream& c) -> Question {
      // Past the filter's guards, but all on one lattice: one axis of a box decides, exactly.
      const auto length = [&c] { return 12 * one_to(c, 3); };
      const double x = length(), y = length(), z = length(), gap = length();
      const double u = length(), v = length(), w = length(), displacement = length();
      static constexpr int exponents[] = {260, -300, 900, -900};
      const int exponent = exponents[c.below(4)];
      // Along each axis in turn.
      const std::uint64_t axis = c.below(3);
      const auto turned = [axis, exponent](double p, double q, double r) {
        const std::array<double, 3> at{std::ldexp(p, exponent), std::ldexp(q, exponent), std::ldexp(r, exponent)};
        return Point3d{at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]};
      };
      const auto box = [&turned](double low, double p, double q, double r) {
        Meshd mesh =
            lattice_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
        for (Point3d& at : mesh.vertices) at = turned(low + p * at.x, q * at.y, r * at.z);
        return mesh;
      };
      const Point3d velocity = turned(displacement, 0, 0);
      return {box(0, x, y, z), box(x + gap, u, v, w), {velocity.x, velocity.y, velocity.z}};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd a = convex_solid_of_polygons(c), b = lattice_polyhedron(c);
      const Meshd asked = c.one_in(6) ? with_broken_polygons(a, c) : a;
      return {asked, shifted(b, 12.0 * lattice_normal(c, 2)), 12.0 * lattice_normal(c, 2)};
    });
  }

  static void repair(Question& question) {
    make_tetrahedron(std::get<0>(question)), make_tetrahedron(std::get<1>(question));
  }

  /// A tetrahedron of size 4 next to another, its top and its velocity on a grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd a{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2 * x, 2 * y, 2 * (z + 1)}}, {}};
    Meshd b{{{4, 4, 4}, {8, 4, 4}, {4, 8, 4}, {4, 4, 8}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b, {2 * u, 2 * v, 2 * w}};
  }

  /// A corner of a passes an edge of b at t = 1/2: moves its velocity.
  static Question map_centre() {
    Meshd a{{{0, 0, 0}, {-12, 0, 0}, {0, -12, 0}, {0, 0, -12}}, {}},
        b{{{12, -6, 0}, {12, 6, 0}, {24, 0, 0}, {12, 0, 12}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b, {24, 0, 0}};
  }

  /// The step: a at its start, at the first contact and at its end; b rests.
  static void draw(Drawing& drawing, const Question& question, const FirstContact<double>& truth) {
    const auto& [a, b, velocity] = question;
    draw_sweep(drawing, "a", a, velocity, truth.t);
    ::touchstone::catalogue::draw(drawing, "b", b, false);
  }

  static Hooks<swept_convex_polyhedra> hooks() {
    return {.as_open_sets = never_if_grazing<swept_convex_polyhedra>,
            .repair = repair,
            .map_centre = map_centre,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  /// Two lattice polyhedra, a point on or near the surface of each, and a velocity with which one comes to the other
  /// at n / d.
  static Question aimed(DrawStream& c, double n, double d) {
    const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
    const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
    const Vector3d w = lattice_normal(c, 4);
    return {a, shifted(b, (p - q) + n * w), d * w};
  }

  static Meshd small_tetrahedron() { return tetrahedron_over({{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}}); }
};

}  // namespace touchstone::catalogue::rows
