// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "catalogue/families/closest_draws.h"
#include "catalogue/families/meshes/convex_pair_draws.h"
#include "catalogue/families/triangles/core_draws.h"
#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/mixed/penetration.h"
#include "oracle/mixed/penetration.h"
#include "reference/mixed/penetration.h"
#include "robust/mixed/penetration.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct penetration : signatures::penetration {
  TOUCHSTONE_MODULES(penetration)
  static constexpr bool takes_prepared = true;
  static auto prepared(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
    using Solid = ::touchstone::robust::ConvexSolid;
    if (is_simplex(a) || is_simplex(b)) return robust(a, b, radius_a, radius_b);  // a simplex is not prepared
    return ::touchstone::robust::penetration(Solid(a), Solid(b), radius_a, radius_b);
  }
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "mixed",
      .pages = "48-50, 53-54",
      .question = "How deep do two round convex solids overlap, and which least translation of a leaves them touching?",
      .kind = Kind::measure,
      .fields = {"a", "b", "radius_a", "radius_b"},
      .ulps = 72,
      .margin_degree = 2,
      .cost = 300,
      .time = {.robust = Growth::quadratic,
               .oracle = Growth::quartic,
               .ask = Growth::quartic,
               .reference = Growth::quadratic},
      .list_length = 4};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", [](DrawStream& c) -> Question {
      const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      return rounded_by(c, a, shifted(b, steps(c)));
    });
    add("aligned_boxes", [](DrawStream& c) -> Question {
      // Several faces are as deep; each is cut into two triangles.
      const Meshd a = box(c), b = box(c);
      return rounded_by(c, a, b);
    });
    add("around_one_center", [](DrawStream& c) -> Question {
      // As deep in opposite directions.
      const Meshd a = around_zero(lattice_polyhedron(c)), b = around_zero(c.coin() ? a : box(c));
      return rounded_by(c, a, c.coin() ? b : reflected(a, {0, 0, 0}));
    });
    add("touching", [](DrawStream& c) -> Question {
      // At a vertex, an edge or a face.
      const auto [a, b] = aimed(c, 0);
      return rounded_by(c, a, b);
    });
    add("an_ulp_apart", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, 0);
      const double far = small_integer(c, 1), side = small_integer(c, 1);
      for (Meshd* mesh : {&a, &b})
        for (Point3d& p : mesh->vertices) p.x += std::ldexp(far, 20);
      for (Point3d& p : b.vertices) p.x = std::nextafter(p.x, p.x + side);
      return rounded_by(c, a, b);
    });
    add("reflected", [](DrawStream& c) -> Question {
      // Each face of one is parallel to one of the other, and so is each edge.
      const Meshd a = lattice_polyhedron(c);
      const Point3d middle = between_vertices(a, c);
      return rounded_by(c, a, reflected(a, middle));
    });
    add("parallel_edges", [](DrawStream& c) -> Question {
      // Roofs whose ridges are below each other; one may be a little askew.
      const double from = small_integer(c), to = small_integer(c), height = up_to(c, 3);
      const double side = small_integer(c, 1), askew = c.coin() ? 0x1p-40 * side : side;
      return rounded_by(c, roof({0, 0, 0}, {8, 0, 0}, -8), roof({from, 0, -height}, {to + 9, askew, -height}, 8));
    });
    add("crossing_edges", [](DrawStream& c) -> Question {
      // Two ridges that cross, one a little below the other: across both is the least translation.
      const double height = up_to(c, 3), x = small_integer(c, 2), askew = small_integer(c, 4);
      const Meshd over =
          tetrahedron_over({{{x, -4, -height}, {x + askew, 4, -height}, {x + 8, 0, 12}, {x - 8, 0, 12}}});
      return rounded_by(c, roof({-4, 0, 0}, {4, 0, 0}, -8), over);
    });
    add("nested", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c);
      const Meshd b = lattice_polyhedron(c);
      for (Point3d& p : a.vertices) p = {8 * p.x - 40, 8 * p.y - 40, 8 * p.z - 40};
      return c.coin() ? rounded_by(c, a, b) : rounded_by(c, b, a);
    });
    add("flat_vertices", [](DrawStream& c) -> Question {
      const Meshd a = with_flat_vertex(lattice_polyhedron(c), c), b = with_flat_vertex(lattice_polyhedron(c), c);
      return rounded_by(c, a, shifted(b, steps(c)));
    });
    add("repeated_vertices", [](DrawStream& c) -> Question {
      // Vertices of no face where others are, with an index below or above these.
      const Meshd a = with_repeated_vertex(box(c), c), b = with_repeated_vertex(box(c), c);
      return rounded_by(c, a, b);
    });
    add("needles", [](DrawStream& c) -> Question {
      auto [a, b] = aimed(c, -1);
      const double length = scaled_up(c, 8, 60), other = scaled_up(c, 8, 60);
      for (Point3d& p : a.vertices) p.x = p.x * length;
      for (Point3d& p : b.vertices) p.y = p.y * other;
      return rounded_by(c, a, b);
    });
    add("stretched", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      Stretch{c, {0, 60, 500, 1010, -170, -900}}(a, b);
      return rounded_by(c, a, b);
    });
    add("mapped", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      map_linearly(c, a, b);
      return rounded_by(c, a, b);
    });
    add("rounded", [](DrawStream& c) -> Question {
      // A corner of b where one of a is, as far as doubles can tell; or anywhere.
      const Meshd a = tetrahedron_of(c, ordinary_point_in_space), b = tetrahedron_of(c, ordinary_point_in_space);
      return rounded_by(c, a, c.coin() ? b : shifted(b, a.vertices[0] - b.vertices[0]));
    });
    add("nearly_as_deep", [](DrawStream& c) -> Question {
      // Two cubes about one center: its depth along the axes differs by an ulp, or not.
      Meshd a = around_zero(cube_surface({{0, 0, 0}})), b = a;
      const double x = within_ulps(c, 12, 1), y = within_ulps(c, 12, 1), z = within_ulps(c, 12, 1);
      for (Point3d& p : b.vertices) p = {p.x + (x - 12), p.y + (y - 12), p.z + (z - 12)};
      return rounded_by(c, a, b);
    });
    add("rounding", [](DrawStream& c) -> Question {
      // The depth is a number halfway between two doubles, or next to it: radii, less a hair between the cores.
      const double x = halfway_number(c), off = hair(c);
      const Meshd b = shifted(cube_surface({{0, 0, 0}}), {0, 0, 0});
      Meshd a = shifted(b, {-12, 0, 0});
      for (Point3d& p : a.vertices) p.x = p.x == 0 ? off : p.x;
      return {a, b, x, 0.5};
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      const Point3d end{step.x, step.y, -hair(c)};
      return {tetrahedron_over({{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}, {0, 0, 4}}}),
              tetrahedron_over({{end, {2 * step.x, step.y, 0}, {step.x, 2 * step.y, 0}, {step.x, step.y, -4}}}),
              up_to(c, 2), up_to(c, 2)};
    });
    add("radii_reach", [](DrawStream& c) -> Question {
      // The cores are apart by an integer, or a whole vector; the radii bridge that, or nearly.
      const Step step = integer_step(c);
      const Radii radii = reaching_radii(c, step.length);
      const Vector3d v = step.displacement, u = {-v.y, v.x, 0}, w = {0, -v.z, v.y};
      const Point3d p{0, 0, 0}, q = p + v;
      return {before(p, -1.0 * v, u, w), before(q, v, u, w), radii.r, radii.s};
    });
    add("radii_nearly_reach", [](DrawStream& c) -> Question {
      const Meshd a = lattice_polyhedron(c);
      const Vector3d v = 12.0 * lattice_normal(c, 4);
      const Meshd b = reflected(shifted(a, v), a.vertices[0] + v);
      return {a, b, near_length(c, v), c.coin() ? 0 : std::ldexp(1, -integer_in(c, 20, 1074))};
    });
    add("far_apart", [](DrawStream& c) -> Question {
      const Meshd a = lattice_polyhedron(c);
      Meshd b = lattice_polyhedron(c);
      b = shifted(b, 96.0 * lattice_normal(c, 2));
      const int places = c.coin() ? 1000 : 60;
      for (Point3d& p : b.vertices) p = scaled(p, places);
      return rounded_by(c, a, b);
    });
    add("typed_shapes", [](DrawStream& c) -> Question {
      return {tetrahedron_of(c, typed_point), tetrahedron_of(c, typed_point), std::fabs(typed(c)), std::fabs(typed(c))};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
      b = shifted(b, steps(c));
      for (Meshd* mesh : {&a, &b})
        for (Point3d& p : mesh->vertices) p = scaled(p, -1074);
      return {a, b, std::fabs(subnormal(c)), std::fabs(subnormal(c))};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      return {tetrahedron_of(c, point_of_full_range), tetrahedron_of(c, point_of_full_range),
              std::fabs(of_full_range(c)), std::fabs(of_full_range(c))};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), q = zero_point(c);
      const double far = small_integer(c, 2);
      const Meshd a = tetrahedron_over({{p, {-1, q.y, q.z}, {q.x, -1, p.z}, {p.x, p.y, -1}}});
      return {a, reflected(a, {far / 4, p.y, p.z}), zero(c), zero(c)};
    });
    add("broken", [](DrawStream& c) -> Question {
      const auto [a, b] = aimed(c, 1);
      return c.coin() ? Question{a, broken(b, c), 0, 0} : Question{broken(a, c), b, 0, 0};
    });
    add("negative_radius", [](DrawStream& c) -> Question {
      const auto [a, b] = aimed(c, 1);
      const double r = small_integer(c, 2), s = small_integer(c, 2);
      return {a, b, r, s};
    });
    add.unscaled("far_from_origin", [](DrawStream& c) -> Question {
      // An octahedron with decimals, and itself, listed in another order: many planes are nearly as near, and rounding
      // decides which vertices seem to be farthest.
      const double far = power_of_two(c, 16, 27);
      const Point3d center{far, c.coin() ? far : 0, c.coin() ? far : 0};
      Meshd a;
      for (int k = 0; k < 3; ++k) {
        const Vector3d v{integer_in(c, -3000, 3000) / 1000.0, integer_in(c, -3000, 3000) / 1000.0,
                         integer_in(c, -3000, 3000) / 1000.0};
        a.vertices.push_back(center + v), a.vertices.push_back(center + (-1.0 * v));
      }
      a.faces = {{0, 2, 4}, {0, 3, 5}, {1, 2, 5}, {1, 3, 4}, {2, 0, 5}, {2, 1, 4}, {3, 0, 4}, {3, 1, 5}};
      const Meshd b = relisted(a, c);
      return {a, b, 0, 0};
    });
    add.unscaled("late_vertices", [](DrawStream& c) -> Question {
      const Meshd a = with_late_corners(c), b = with_late_corners(c);
      return rounded_by(c, a, shifted(b, 2048.0 * lattice_normal(c, 2)));
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd a = convex_solid_of_polygons(c), b = lattice_polyhedron(c);
      const Meshd given = c.one_in(6) ? with_broken_polygons(a, c) : a, moved = shifted(b, steps(c));
      return rounded_by(c, given, moved);
    });
    add_round_cores(add);
  }

  static void repair(Question& question) {
    auto& [a, b, radius_a, radius_b] = question;
    make_tetrahedron(a), make_tetrahedron(b);
    radius_a = std::fabs(radius_a), radius_b = std::fabs(radius_b);
  }

  /// Two tetrahedra, the top of one and the place of the other on a grid, and one radius; the other is 1 more than the
  /// least number of the grid.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd a{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2 * x, 2 * y, 2 * (z + 1)}}, {}};
    Meshd b{{{2 * u, 2 * v, 2}, {2 * u + 4, 2 * v, 4}, {2 * u, 2 * v + 4, 4}, {2 * u, 2 * v, 8}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b, w + 1, 1};
  }

  /// A corner of a is in a face of b: moves that corner.
  static Question map_centre() {
    Meshd a{{{12, 0, 0}, {-12, 0, 0}, {0, -12, 0}, {0, 0, -12}}, {}},
        b{{{12, -6, -6}, {12, 6, -6}, {24, 0, 0}, {12, 0, 12}}, {}};
    make_tetrahedron(a), make_tetrahedron(b);
    return {a, b, 0, 0};
  }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  static std::optional<Penetration<TrueNumber>> as_open_sets(const Penetration<TrueNumber>& truth, const Question&) {
    if (truth.contact != Contact::touching) return std::nullopt;
    Penetration<TrueNumber> open = truth;
    open.contact = Contact::disjoint;
    return open;
  }

  static std::optional<Penetration<TrueNumber>> as_near(const Question& question, const Penetration<TrueNumber>&,
                                                        const Penetration<double>& answer) {
    const auto& [a, b, radius_a, radius_b] = question;
    return ::touchstone::oracle::as_deep(a, b, radius_a, radius_b, answer.direction);
  }

  static Hooks<penetration> hooks() {
    return {.as_open_sets = as_open_sets,
            .as_near = as_near,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .domain_count = domain_count,
            .domain_at = domain_at};
  }

 private:
  /// Two meshes with radii, often 0.
  static Question rounded_by(DrawStream& c, const Meshd& a, const Meshd& b) {
    const double r = up_to(c, 2), s = up_to(c, 2);
    return {a, b, r, s};
  }
  static Vector3d steps(DrawStream& c) {
    return {6 * small_integer(c, 3), 6 * small_integer(c, 3), 6 * small_integer(c, 3)};
  }
  /// Corner and size on a small grid.
  static Meshd box(DrawStream& c) {
    const Point3d corner{small_integer(c, 3), small_integer(c, 3), small_integer(c, 3)};
    const Vector3d size{one_to(c, 4), one_to(c, 4), one_to(c, 4)};
    Meshd mesh = cube_surface({{0, 0, 0}});
    for (Point3d& p : mesh.vertices)
      p = {corner.x + size.x * p.x / 12, corner.y + size.y * p.y / 12, corner.z + size.z * p.z / 12};
    return mesh;
  }
  /// Twice the mesh; the middle of the box around it is the origin.
  static Meshd around_zero(Meshd mesh) {
    Point3d low = mesh.vertices[0], high = low;
    for (const Point3d& p : mesh.vertices) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    for (Point3d& p : mesh.vertices) p = {2 * p.x - low.x - high.x, 2 * p.y - low.y - high.y, 2 * p.z - low.z - high.z};
    return mesh;
  }
  /// A corner, and the others beyond it along a displacement.
  static Meshd before(const Point3d& p, const Vector3d& v, const Vector3d& u, const Vector3d& w) {
    const Vector3d across = dot(w, w) > 0 ? w : Vector3d{0, 0, 1};
    return tetrahedron_over({{p, p + (v + u), p + (v - u), p + (v + across)}});
  }
};

}  // namespace touchstone::catalogue::rows
