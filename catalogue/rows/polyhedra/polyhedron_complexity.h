// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/meshes/contact_mesh_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/prism_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/meshes/wrong_cuts.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/polyhedron_complexity.h"
#include "oracle/polyhedra/polyhedron_complexity.h"
#include "reference/polyhedra/polyhedron_complexity.h"
#include "robust/polyhedra/polyhedron_complexity.h"

namespace touchstone::catalogue::rows {

struct polyhedron_complexity : signatures::polyhedron_complexity {
  TOUCHSTONE_MODULES(polyhedron_complexity)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "26",
      .question = "Of how many vertices, edges, faces and parts is the mesh; is it a surface, and where not?",
      .kind = Kind::measure,
      .fields = {"mesh"},
      .margin_degree = 0,
      .cost = 80,
      .time = {.robust = Growth::linearithmic,
               .oracle = Growth::quadratic,
               .ask = Growth::quadratic,
               .reference = Growth::quadratic},
      .list_length = 5};

  static void hard_cases(HardCases<Question>& add) {
    add("solid", [](DrawStream& c) -> Question { return {lattice_solid(c)}; });
    add("convex", [](DrawStream& c) -> Question { return {lattice_polyhedron(c)}; });
    add("sheets_at_a_vertex", [](DrawStream& c) -> Question { return {sheets_at_a_vertex(c)}; });
    add("tetrahedra", [](DrawStream& c) -> Question { return {tetrahedra_together(c)}; });
    add("needless_faces", [](DrawStream& c) -> Question { return {with_needless_faces(lattice_solid(c), c)}; });
    add("with_a_rim", [](DrawStream& c) -> Question {
      Meshd mesh = c.coin() ? sheets_at_a_vertex(c) : lattice_polyhedron(c);
      for (std::uint64_t left = 1 + c.below(4); left > 0 && mesh.faces.size() > 4; --left)
        mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(c.below(mesh.faces.size())));
      return {mesh};
    });
    add("opened", [](DrawStream& c) -> Question { return {opened(lattice_solid(c), c)}; });
    add("small_lattice", [](DrawStream& c) -> Question { return {small_lattice_faces(c)}; });
    add("flat_part", [](DrawStream& c) -> Question { return {flat_part(c)}; });
    add("flat_vertex", [](DrawStream& c) -> Question { return {with_flat_vertex(lattice_polyhedron(c), c)}; });
    add("folded_flap", [](DrawStream& c) -> Question { return {folded_flap(c)}; });
    add("touching_solids", [](DrawStream& c) -> Question { return {touching_solids(c)}; });
    add("fans_at_a_vertex", [](DrawStream& c) -> Question { return {fans_at_a_vertex(c)}; });
    add("nested_shells", [](DrawStream& c) -> Question { return {nested_shells(c)}; });
    add("repeated_vertices",
        [](DrawStream& c) -> Question { return {with_repeated_vertices(lattice_polyhedron(c), c)}; });
    add("reported", [](DrawStream& c) -> Question { return {reported_faces(c)}; });
    add("stretched", [](DrawStream& c) -> Question {
      return {with_stretched_axes(c.coin() ? small_lattice_faces(c) : lattice_solid(c), c)};
    });
    add.unscaled("named_mesh", [](DrawStream& c) -> Question { return {named_mesh(c)}; });
    add.unscaled("named_solid", [](DrawStream& c) -> Question { return {named_solid(c)}; });
    add.unscaled("reported_cgal_9486", [](DrawStream& c) -> Question { return {relisted(reported::cgal_9486(), c)}; });
    add.unscaled("reported_cgal_9192", [](DrawStream& c) -> Question {
      const auto [a, b] = reported::cgal_9192(integer_in(c, 0, 2));
      return {relisted(together(a, b), c)};
    });
    add.unscaled("reported_manifold_1656", [](DrawStream& c) -> Question {
      return {relisted(c.coin() ? reported::manifold_1656_united() : reported::manifold_1656_kept(), c)};
    });
    add.unscaled("reported_libigl_2381",
                 [](DrawStream& c) -> Question { return {relisted(reported::libigl_2381(), c)}; });
    add.unscaled("reported_vcad_6", [](DrawStream& c) -> Question {
      // In one list of vertices, or as two boxes.
      const auto [a, b] = reported::vcad_6();
      return {relisted(c.coin() ? together(a, b) : reported::vcad_6_kept(), c)};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      Meshd mesh = c.one_in(3) ? convex_solid_of_polygons(c) : solid_of_polygons(c);
      switch (c.below(6)) {
        case 4: return {together(mesh, solid_of_polygons(c))};
        case 5: return {with_broken_polygons(mesh, c)};
        default: return {mesh};
      }
    });
    add.unscaled("polygons_with_a_rim", [](DrawStream& c) -> Question {
      const Meshd mesh = c.coin() ? lattice_solid(c) : flat_part(c);
      Meshd part{mesh.vertices, mesh.faces, {}};
      for (std::uint64_t left = c.below(4); left > 0 && part.faces.size() > 8; --left)
        part.faces.erase(part.faces.begin() + static_cast<std::ptrdiff_t>(c.below(part.faces.size())));
      return {with_polygons(part, c)};
    });
    add.unscaled("prisms", [](DrawStream& c) -> Question { return {c.one_in(4) ? two_prisms(c) : drawn_prism(c)}; });
    add.unscaled("fins", [](DrawStream& c) -> Question { return {with_fin(drawn_prism(c), c)}; });
    add.unscaled("wrong_cuts", [](DrawStream& c) -> Question {
      const Meshd mesh = drawn_prism(c);
      return {c.coin() ? with_wrong_polygon(mesh, c) : with_wrong_cut(mesh, c)};
    });
    add.unscaled("wrong_polygon", [](DrawStream& c) -> Question { return {with_wrong_polygon(drawn_prism(c), c)}; });
    add.unscaled("foreign_cut", [](DrawStream& c) -> Question { return {with_foreign_cut(drawn_prism(c), c)}; });
    add.unscaled("lifted_corner", [](DrawStream& c) -> Question { return {with_lifted_corner(drawn_prism(c), c)}; });
    add.unscaled("convex_at_a_vertex", [](DrawStream& c) -> Question { return {convex_at_a_vertex(c)}; });
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      const Meshd mesh = c.one_in(4) ? lattice_polyhedron(c) : lattice_solid(c);
      return {with_unnamed_vertices(mesh, between_vertices(mesh, c), c)};
    });
  }

  static void repair(Question& question) { make_solid(std::get<0>(question)); }

  /// Six triangles over five vertices, each one of so many, in either direction.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    std::vector<Face> triangles;
    for (Index a = 0; a < 3; ++a) {
      for (Index b = a + 1; b < 4; ++b) {
        for (Index c = b + 1; c < 5; ++c) triangles.insert(triangles.end(), {{a, b, c}, {b, a, c}});
      }
    }
    Meshd mesh = dented_tetrahedron(24, {6, 6, 6});
    mesh.faces.clear();
    for (std::size_t k = 0; k < 6; ++k)
      mesh.faces.push_back(triangles[(7 * k + 3 * static_cast<std::size_t>(digit())) % triangles.size()]);
    return {mesh};
  }

  static Hooks<polyhedron_complexity> hooks() {
    return {.repair = repair,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true, .reflected = {{"positive", "negative"}}}};
  }
};

}  // namespace touchstone::catalogue::rows
