// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "oracle/polyhedra/point_in_convex_polyhedron.h"
#include "reference/polyhedra/point_in_convex_polyhedron.h"
#include "robust/batch/point_in_convex_polyhedron.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::catalogue::rows {

struct point_in_convex_polyhedron {
  TOUCHSTONE_MODULES(point_in_convex_polyhedron)
  TOUCHSTONE_ARRAYS(point_in_convex_polyhedron)
  using stages = ::touchstone::robust::stages::point_in_convex_polyhedron;
  using Question = std::tuple<Meshd, Point3d>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{
        .name = "point_in_convex_polyhedron",
        .chapter = "polyhedra",
        .pages = "53",
        .question = "Does the point lie inside the convex polyhedron, on a face, or outside?",
        .kind = Kind::decision,
        .fields = {"mesh", "point"},
        .answer = "location",
        .margin_degree = 2,
        .cost = 69,
        .time = {.robust = Growth::quadratic,
                 .oracle = Growth::quadratic,
                 .ask = Growth::quadratic,
                 .reference = Growth::linear},
        .list_length = 4};
    return metadata;
  }

  static void hard_cases(HardCases<Question>& add) {
    add("on_face_plane", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_polyhedron(c);
      return {mesh, on_a_face_plane(mesh, c)};
    });
    add("between_vertices", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_polyhedron(c);
      return {mesh, between_vertices(mesh, c)};
    });
    add("near_face", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_polyhedron(c);
      const Point3d p = on_a_face_plane(mesh, c);
      return {mesh, {p.x + small_integer(c, 1), p.y + small_integer(c, 1), p.z + small_integer(c, 1)}};
    });
    add("flat_vertices", [](DrawStream& c) -> Question {
      Meshd mesh = lattice_polyhedron(c);
      for (std::uint64_t left = 1 + c.below(3); left > 0; --left) {
        for (Point3d& p : mesh.vertices) p = {6 * p.x, 6 * p.y, 6 * p.z};
        mesh = with_flat_vertex(mesh, c);
      }
      return {mesh, on_a_face_plane(mesh, c)};
    });
    add("mapped", [](DrawStream& c) -> Question {
      Question question;
      auto& [mesh, point] = question;
      mesh = lattice_polyhedron(c);
      point = on_a_face_plane(mesh, c);
      map_linearly(mesh, point, c);
      return question;
    });
    add("stretched", [](DrawStream& c) -> Question {
      // Each axis by its own power of two: past the lattice, past the filter's guard, below its absolute term.
      Question question;
      auto& [mesh, point] = question;
      mesh = lattice_polyhedron(c);
      point = on_a_face_plane(mesh, c);
      static constexpr int exponents[] = {0, 60, 255, -170, 300, -300};
      const int x = exponents[c.below(6)], y = exponents[c.below(6)], z = exponents[c.below(6)];
      const auto stretch = [=](Point3d& p) { p = {std::ldexp(p.x, x), std::ldexp(p.y, y), std::ldexp(p.z, z)}; };
      std::for_each(mesh.vertices.begin(), mesh.vertices.end(), stretch);
      stretch(point);
      return question;
    });
    add("rounded_on_face", [](DrawStream& c) -> Question {
      const auto number = [&c] { return ordinary(c); };
      Question question;
      auto& [mesh, point] = question;
      for (int i = 0; i < 4; ++i) {
        const double x = number(), y = number(), z = number();
        mesh.vertices.push_back({x, y, z});
      }
      make_tetrahedron(mesh);
      const auto &a = mesh.vertices[0], &b = mesh.vertices[1], &d = mesh.vertices[2];
      const double s = number(), t = number();
      point = a + (s * (b - a)) + (t * (d - a));
      return question;
    });
    add("broken", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_polyhedron(c);
      const Point3d point = between_vertices(mesh, c);
      return {broken(mesh, c), point};
    });
    add.unscaled("named_mesh", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_mesh(c);
      return {mesh, c.one_in(4) ? between_vertices(mesh, c) : on_a_face_plane(mesh, c)};
    });
    add.unscaled("beside_named_mesh", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_mesh(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const auto ulps = [&c] { return static_cast<int>(small_integer(c, 2)); };
      return {mesh, {moved_by_ulps(p.x, ulps()), moved_by_ulps(p.y, ulps()), moved_by_ulps(p.z, ulps())}};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = convex_solid_of_polygons(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      const Meshd asked = c.one_in(4) ? with_broken_polygons(mesh, c) : mesh;
      return {asked, p};
    });
  }

  static void repair(Question& question) { make_tetrahedron(std::get<0>(question)); }

  /// Tetrahedra of size 12 and a point that runs over the numbers from 0 in thirds of 12, so that many lie on faces,
  /// edges and corners: the vertex opposite the corner at the origin, and the point.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd mesh{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {4 * x, 4 * y, 4 * (z + 1)}}, {}};
    make_tetrahedron(mesh);
    return {mesh, {4 * u, 4 * v, 4 * w}};
  }

  /// The point (4, 4, 4) is on the face between the axes.
  static Question map_centre() {
    Meshd mesh{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}, {}};
    make_tetrahedron(mesh);
    return {mesh, {4, 4, 4}};
  }

  static Hooks<point_in_convex_polyhedron> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
