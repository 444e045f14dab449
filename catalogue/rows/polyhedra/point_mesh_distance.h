// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/draw/figures.h"
#include "catalogue/families/closest_draws.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/prism_draws.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/point_mesh_distance.h"
#include "oracle/polyhedra/point_mesh_distance.h"
#include "reference/polyhedra/point_mesh_distance.h"
#include "robust/polyhedra/point_mesh_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct point_mesh_distance : signatures::point_mesh_distance {
  TOUCHSTONE_STAGED_MODULES(point_mesh_distance)
  TOUCHSTONE_PREPARED(point_mesh_distance, Solid)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "9, 14-15, 53-54",
      .question = "Which point of the surface of a solid is nearest to the point, how far is it, and on which side?",
      .kind = Kind::measure,
      .fields = {"point", "mesh"},
      .ulps = 66,
      .margin_degree = 2,
      .cost = 150,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::linearithmic,
               .ask = Growth::linearithmic,
               .reference = Growth::linear},
      .list_length = 5};

  static void hard_cases(HardCases<Question>& add) {
    add("on_face_plane", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      return {on_a_face_plane(mesh, c), mesh};
    });
    add("off_face_edge_or_vertex", off_surface);
    add("near_surface", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      return {beside(on_a_face_plane(mesh, c), c), mesh};
    });
    add("between_vertices", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      return {between_vertices(mesh, c), mesh};
    });
    add("as_near_to_many", of<place_in_crossing_boxes>);
    add("shells", of<place_in_shells>);
    add("body_in_recess", of<place_in_recess>);
    add("tetrahedra", of<place_at_tetrahedra>);
    add("needless_faces", of<place_at_needless_faces>);
    add("face_listed_twice", of<place_at_face_listed_twice>);
    add("rounded_ties", [](DrawStream& c) -> Question {
      // Between two boxes, an ulp or a few nearer to one of them.
      const double x = ulps_apart(c, 1.75, 4), y = small_integer(c, 2), z = small_integer(c, 2), size = one_to(c, 4);
      const Meshd below = box_mesh({-4, -4, -4}, {-1.75, size, 4}), above = box_mesh({x, -4, -4}, {4, 4, size});
      return {{hair(c), y, z}, c.coin() ? together(below, above) : together(above, below)};
    });
    add("needles", [](DrawStream& c) -> Question {
      Meshd mesh = lattice_solid(c);
      const double length = power_of_two(c, 8, 60);
      for (Point3d& p : mesh.vertices) p.x = length * p.x;
      const Point3d p = on_a_face_plane(mesh, c);
      return {p + lattice_normal(c, 4), mesh};
    });
    add("far_from_origin", [](DrawStream& c) -> Question {
      // Beyond the digits of floats, in which boxes are compared.
      const auto [p, mesh] = off_surface(c);
      const auto far = [&c] {
        const double sign = either_sign(c);
        return sign * power_of_two(c, 18, 40);
      };
      const Vector3d by{far(), far(), far()};
      return {p + by, shifted(mesh, by)};
    });
    add("far_away", [](DrawStream& c) -> Question {
      const auto [p, mesh] = off_surface(c);
      const double far = power_of_two(c, 10, 60);
      return {along(p, far, lattice_normal(c, 2)), mesh};
    });
    add("rounded_on_face", of<rounded_place_on_face>);
    add("full_mantissa", [](DrawStream& c) -> Question {
      const Meshd mesh = ordinary_solid(c);
      return {ordinary_point_in_space(c), mesh};
    });
    add("rounding", [](DrawStream& c) -> Question {
      // As convex_distance has it: a coordinate halfway between two doubles.
      const double x = halfway_number(c), odd = 1 + 2 * up_to(c, 7);
      return {{x + odd, 0, hair(c)}, tetrahedron_over({{{x, 0, 0}, {x + 64, 64, 0}, {x, 64, 32}, {x, 64, -32}}})};
    });
    add("rounding_of_distance", [](DrawStream& c) -> Question {
      const HalfwayStep step = halfway_step(c);
      return {{step.x, step.y, -hair(c)}, tetrahedron_over({{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}, {0, 0, 4}}})};
    });
    add("mapped", [](DrawStream& c) -> Question {
      auto [p, mesh] = off_surface(c);
      map_linearly(c, p, mesh);
      return {p, mesh};
    });
    add("stretched", [](DrawStream& c) -> Question {
      auto [p, mesh] = off_surface(c);
      Stretch{c, {0, 54, 60, 255, -64, -170, 300, -300, 1015, -1074}}(p, mesh);
      return {p, mesh};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      auto [p, mesh] = off_surface(c);
      const auto least = [](Point3d& q) { q = scaled(q, -1074); };
      change_each(mesh, least), least(p);
      return {p, mesh};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c);
      return {p, tetrahedron_of(c, point_of_full_range)};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d p = zero_point(c), q = zero_point(c), r = zero_point(c);
      return {r, tetrahedron_over({{p, {-1, q.y, q.z}, {q.x, -1, p.z}, {p.x, p.y, -1}}})};
    });
    add("opened", [](DrawStream& c) -> Question {
      const auto [p, mesh] = off_surface(c);
      return {p, opened(mesh, c)};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = solid_of_polygons(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return {p + lattice_normal(c, 2), c.one_in(6) ? with_broken_polygons(mesh, c) : mesh};
    });
    add.unscaled("prisms", [](DrawStream& c) -> Question {
      const Meshd mesh = drawn_prism(c);
      return {c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c), mesh};
    });
    add.unscaled("named_solid", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_solid(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return {c.coin() ? Point3d{p.x / 2, p.y, p.z} : beside_by_ulps(p, c), mesh};
    });
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      const auto [p, mesh] = off_surface(c);
      return {p, with_unnamed_vertices(mesh, p, c)};
    });
    add.unscaled("long_mesh", of<place_at_long_solid>);
  }

  static void repair(Question& question) { make_solid(std::get<1>(question)); }

  /// Tetrahedra of size 12 with a dent, or a spike, in the face away from the origin, and a point: both run over the
  /// numbers from 0 in thirds of 12.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    return {{4 * u, 4 * v, 4 * w}, dented_tetrahedron(12, {4 * x, 4 * y, 4 * z})};
  }

  /// At the end of the dent.
  static Question map_centre() { return {{2, 2, 2}, dented_tetrahedron(12, {2, 2, 2})}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// An open solid does not have its boundary.
  static std::optional<PointMeshDistance<TrueNumber>> as_open_sets(const PointMeshDistance<TrueNumber>& truth,
                                                                   const Question&) {
    if (truth.location != Location::boundary) return std::nullopt;
    auto open = truth;
    open.location = Location::outside;
    return open;
  }
  static std::optional<PointMeshDistance<TrueNumber>> as_near(const Question& question,
                                                              const PointMeshDistance<TrueNumber>& truth,
                                                              const PointMeshDistance<double>& answer) {
    const auto& [point, mesh] = question;
    return ::touchstone::oracle::as_near(point, mesh, truth, answer.nearest.point);
  }

  static Hooks<point_mesh_distance> hooks() {
    return {.as_open_sets = as_open_sets,
            .as_near = as_near,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .domain_count = domain_count,
            .domain_at = domain_at};
  }

 private:
  template <auto place>
  static Question of(DrawStream& c) {
    const auto [mesh, point] = place(c);
    return {point, mesh};
  }
  /// From a vertex, an edge or a face of a solid, or from beyond it in its plane, some steps away.
  static Question off_surface(DrawStream& c) {
    const Meshd mesh = lattice_solid(c);
    const Point3d p = on_a_face_plane(mesh, c);
    const double steps = small_integer(c, 4);
    return {along(p, steps, lattice_normal(c, 3)), mesh};
  }
};

}  // namespace touchstone::catalogue::rows
