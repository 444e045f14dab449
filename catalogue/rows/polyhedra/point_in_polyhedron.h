// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/prism_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/meshes/wrong_cuts.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/point_in_polyhedron.h"
#include "oracle/polyhedra/point_in_polyhedron.h"
#include "reference/polyhedra/point_in_polyhedron.h"
#include "robust/batch/point_in_polyhedron.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct point_in_polyhedron : signatures::point_in_polyhedron {
  TOUCHSTONE_STAGED_MODULES(point_in_polyhedron)
  TOUCHSTONE_PREPARED(point_in_polyhedron, Solid)
  TOUCHSTONE_ARRAYS(point_in_polyhedron)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "14-15, 53",
      .question = "Does the point lie inside the solid of a closed mesh, on a face, or outside?",
      .kind = Kind::decision,
      .fields = {"mesh", "point"},
      .answer = "location",
      .margin_degree = 2,
      .cost = 69,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::linearithmic,
               .ask = Growth::linearithmic,
               .reference = Growth::linear},
      .list_length = 5};

  static void hard_cases(HardCases<Question>& add) {
    add("on_face", mesh_and_point<lattice_solid, on_a_face_plane>);
    add("ray_through", [](DrawStream& c) -> Question {
      // Before or behind a vertex, an edge, a face, along an axis.
      const Meshd mesh = lattice_solid(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const double displacement = 4 * small_integer(c, 8);
      switch (c.below(4)) {
        case 0: return {mesh, {p.x, p.y + displacement, p.z}};
        case 1: return {mesh, {p.x, p.y, p.z + displacement}};
        default: return {mesh, {p.x + displacement, p.y, p.z}};
      }
    });
    add("near_face", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      return {mesh, beside(on_a_face_plane(mesh, c), c)};
    });
    add("between_vertices", mesh_and_point<lattice_solid, between_vertices>);
    add("tetrahedra", place_at_tetrahedra);
    add("needless_faces", place_at_needless_faces);
    add("mapped", [](DrawStream& c) -> Question {
      Question question = mesh_and_point<lattice_solid, on_a_face_plane>(c);
      map_linearly(c, std::get<0>(question), std::get<1>(question));
      return question;
    });
    add("stretched", [](DrawStream& c) -> Question {
      // To both ends of the range.
      auto [mesh, p] = mesh_and_point<lattice_solid, on_a_face_plane>(c);
      const Stretch stretch(c, {0, 60, 255, -170, 300, -300, 1015, -1074});
      p.x += small_integer(c, 1);
      stretch(mesh, p);
      return {mesh, p};
    });
    add("rounded_on_face", rounded_place_on_face);
    add("opened", [](DrawStream& c) -> Question {
      const auto [mesh, point] = mesh_and_point<lattice_solid, between_vertices>(c);
      return {opened(mesh, c), point};
    });
    add.unscaled("named_solid", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_solid(c);
      const Point3d p = c.one_in(3) ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return {mesh, c.coin() ? Point3d{p.x / 2, p.y, p.z} : p};
    });
    add.unscaled("beside_named_solid", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_solid(c);
      return {mesh, beside_by_ulps(on_a_face_plane(mesh, c), c)};
    });
    add.unscaled("reported_trimesh_2534", [](DrawStream& c) -> Question {
      const double x = c.coin() ? 0.2 : 0;
      return {relisted(reported::trimesh_2534(), c), {x, 0, 0}};
    });
    add.unscaled("reported_trimesh_242", [](DrawStream& c) -> Question {
      // Corners of cells, middles of edges, of sides, of cells.
      const auto eighth = [&c] { return up_to(c, 8) / 8 - 0.5; };
      const double x = eighth(), y = eighth(), z = eighth();
      return {relisted(reported::trimesh_242(), c), {x, y, z}};
    });
    add.unscaled("reported_edyn_155", [](DrawStream& c) -> Question {
      // On the ray: where it begins, in the middle, behind.
      const double at = 2 - 2 * up_to(c, 2);
      const std::uint64_t axis = c.below(3);
      return {relisted(reported::edyn_155(), c), {axis == 0 ? at : 0, axis == 1 ? at : 0, axis == 2 ? at : 0}};
    });
    add.unscaled("reported_parry_171", [](DrawStream& c) -> Question {
      // As high as the ridge, or half as high: before, under or at it, behind.
      const double x = 5 * up_to(c, 2) - 3, y = 5 * up_to(c, 2) - 2;
      const double z = 2 - up_to(c, 1);
      return {relisted(reported::parry_171(), c), {x, y, z}};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = solid_of_polygons(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return {c.one_in(4) ? with_broken_polygons(mesh, c) : mesh, p};
    });
    add.unscaled("prisms", [](DrawStream& c) -> Question {
      const Meshd mesh = drawn_prism(c);
      return {mesh, c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c)};
    });
    add.unscaled("wrong_cuts", [](DrawStream& c) -> Question {
      const auto [mesh, p] = mesh_and_point<drawn_prism, between_vertices>(c);
      return {c.coin() ? with_wrong_polygon(mesh, c) : with_wrong_cut(mesh, c), p};
    });
    add.unscaled("shells", place_in_shells);
    add.unscaled("body_in_recess", place_in_recess);
    add.unscaled("crossing_boxes", place_in_crossing_boxes);
    add.unscaled("face_listed_twice", place_at_face_listed_twice);
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      Point3d p = between_vertices(mesh, c);
      p.x += 4 * small_integer(c, 2);
      const Point3d q = c.one_in(4) ? between_vertices(mesh, c) : p;
      return {with_unnamed_vertices(mesh, q, c), p};
    });
    add.unscaled("long_mesh", place_at_long_solid);
  }

  static void repair(Question& question) { make_solid(std::get<0>(question)); }

  /// Tetrahedra of size 12 with a dent, or a spike, in the face away from the origin, and a point: both run over the
  /// numbers from 0 in thirds of 12.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    return {dented_tetrahedron(12, {4 * x, 4 * y, 4 * z}), {4 * u, 4 * v, 4 * w}};
  }

  /// At the end of the dent.
  static Question map_centre() { return {dented_tetrahedron(12, {2, 2, 2}), {2, 2, 2}}; }

  static Hooks<point_in_polyhedron> hooks() {
    return {.as_open_sets = outside_if_on_boundary<Question>,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }
};

}  // namespace touchstone::catalogue::rows
