// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/point_in_convex_polyhedron.h"
#include "oracle/polyhedra/point_in_convex_polyhedron.h"
#include "reference/polyhedra/point_in_convex_polyhedron.h"
#include "robust/batch/point_in_convex_polyhedron.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct point_in_convex_polyhedron : signatures::point_in_convex_polyhedron {
  TOUCHSTONE_STAGED_MODULES(point_in_convex_polyhedron)
  TOUCHSTONE_PREPARED(point_in_convex_polyhedron, ConvexSolid)
  TOUCHSTONE_ARRAYS(point_in_convex_polyhedron)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
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

  static void hard_cases(HardCases<Question>& add) {
    add("on_face_plane", mesh_and_point<lattice_polyhedron, on_a_face_plane>);
    add("between_vertices", mesh_and_point<lattice_polyhedron, between_vertices>);
    add("near_face", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_polyhedron(c);
      return {mesh, beside(on_a_face_plane(mesh, c), c)};
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
      Question question = mesh_and_point<lattice_polyhedron, on_a_face_plane>(c);
      map_linearly(c, std::get<0>(question), std::get<1>(question));
      return question;
    });
    add("stretched", [](DrawStream& c) -> Question {
      Question question = mesh_and_point<lattice_polyhedron, on_a_face_plane>(c);
      Stretch{c}(std::get<0>(question), std::get<1>(question));
      return question;
    });
    add("rounded_on_face", [](DrawStream& c) -> Question {
      const Meshd mesh = tetrahedron_of(c, ordinary_point_in_space);
      const auto &a = mesh.vertices[0], &b = mesh.vertices[1], &d = mesh.vertices[2];
      const double s = ordinary(c), t = ordinary(c);
      return {mesh, a + (s * (b - a)) + (t * (d - a))};
    });
    // Closed, no edge bends outwards, and the middle is behind each face; but the surface goes around it twice.
    // Or two solids, apart: the middle is behind some faces only.
    add.unscaled("wound_twice", [](DrawStream& c) -> Question {
      const double far = 1 + static_cast<double>(c.below(3));
      Meshd mesh{{{0, 0, far}, {0, 0, -far}, {0, 3, 0}, {-3, 1, 0}, {-2, -3, 0}, {2, -3, 0}, {3, 1, 0}}, {}};
      if (c.coin()) {
        for (Index k = 0; k < 5; ++k) {
          const Index from = 2 + k, to = 2 + (k + 2) % 5;
          mesh.faces.push_back({0, from, to}), mesh.faces.push_back({1, to, from});
        }
      } else {
        mesh = lattice_polyhedron(c);
        const bool apart = c.coin();
        const auto count = static_cast<Index>(mesh.vertices.size());
        for (Index i = 0; i < count; ++i) {
          const Point3d p = mesh.vertices[i];
          mesh.vertices.push_back(apart ? Point3d{p.x + 0x1p20, p.y, p.z} : Point3d{2 * p.x, 2 * p.y, 2 * p.z});
        }
        for (std::size_t i = 0, faces = mesh.faces.size(); i < faces; ++i) {
          const auto [p, q, r] = mesh.faces[i];
          mesh.faces.push_back({p + count, q + count, r + count});
        }
      }
      return {mesh, between_vertices(mesh, c)};
    });
    add("broken", [](DrawStream& c) -> Question {
      const auto [mesh, point] = mesh_and_point<lattice_polyhedron, between_vertices>(c);
      return {broken(mesh, c), point};
    });
    add.unscaled("named_mesh", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_mesh(c);
      return {mesh, c.one_in(4) ? between_vertices(mesh, c) : on_a_face_plane(mesh, c)};
    });
    add.unscaled("beside_named_mesh", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_mesh(c);
      return {mesh, beside_by_ulps(on_a_face_plane(mesh, c), c)};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = convex_solid_of_polygons(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return {c.one_in(4) ? with_broken_polygons(mesh, c) : mesh, p};
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
