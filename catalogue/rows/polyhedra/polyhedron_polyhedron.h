// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/polyhedron_polyhedron.h"
#include "oracle/polyhedra/polyhedron_polyhedron.h"
#include "reference/polyhedra/polyhedron_polyhedron.h"
#include "robust/polyhedra/polyhedron_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::catalogue::rows {

struct polyhedron_polyhedron : signatures::polyhedron_polyhedron {
  TOUCHSTONE_STAGED_MODULES(polyhedron_polyhedron)
  TOUCHSTONE_PREPARED(polyhedron_polyhedron, Solid)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "25, 52-54",
      .question = "Do two polyhedra collide, convex or not, and which step of the test tells?",
      .kind = Kind::decision,
      .fields = {"a", "b"},
      .margin_degree = 2,
      .cost = 1000,
      .time = grows(Growth::quadratic),
      .list_length = 5};

  static void hard_cases(HardCases<Question>& add) {
    add("lattice", [](DrawStream& c) -> Question { return {lattice_solid(c), moved(lattice_solid(c), c, 12, 3)}; });
    add("feature_to_feature", touching<lattice_solid, lattice_solid>);
    add("convex", touching<lattice_polyhedron, lattice_polyhedron>);
    add("equal", [](DrawStream& c) -> Question {
      // Or cut in other triangles, turned inside out, a little way off.
      const Meshd a = lattice_solid(c);
      Meshd b = a;
      if (c.coin()) b = with_flat_vertex(b, c);
      if (c.coin()) turn_inside_out(b);
      return {a, moved(b, c, 6, 1)};
    });
    add("one_within", [](DrawStream& c) -> Question {
      return {times(3, lattice_solid(c)), moved(lattice_polyhedron(c), c, 12, 4)};
    });
    add("interlocked", [](DrawStream& c) -> Question {
      // Links of a chain, or crossing sticks: no vertex is within the other.
      const Meshd a = link(c), b = mapped(link(c), [](const Point3d&p) { return Point3d{p.y, p.z, p.x}; });
      return {a, moved(b, c, 6, 3)};
    });
    add("cubes", [](DrawStream& c) -> Question {
      return {cube_surface(cells(c)), moved(cube_surface(cells(c)), c, 12, 2)};
    });
    add("tetrahedra", [](DrawStream& c) -> Question {
      return {tetrahedra_together(c), moved(tetrahedra_together(c), c, 12, 1)};
    });
    add("needless_faces", [](DrawStream& c) -> Question {
      const Meshd a = with_needless_faces(times(6, lattice_solid(c)), c);
      const double size = one_to(c, 6);
      const Meshd b = times(size, lattice_polyhedron(c));
      const Point3d p = c.coin() ? a.vertices.back() : on_a_face_plane(a, c);
      return {a, shifted(b, p - between_vertices(b, c))};
    });
    add("mapped", [](DrawStream& c) -> Question {
      auto [a, b] = touching<lattice_polyhedron, dented_tetrahedron_of_24>(c);
      map_linearly(c, a, b);
      return {a, b};
    });
    add("stretched", [](DrawStream& c) -> Question {
      // To both ends of the range.
      auto [a, b] = touching<lattice_polyhedron, dented_tetrahedron_of_24>(c);
      Stretch{c, {0, 60, 255, -170, 300, -300, 1013, -1074}}(a, b);
      return {a, b};
    });
    add("rounded_onto", [](DrawStream& c) -> Question {
      // A corner of one, as far as doubles can tell, on a face of the other.
      const Meshd a = ordinary_solid(c), b = ordinary_solid(c);
      const auto &p = a.vertices[1], &q = a.vertices[2], &r = a.vertices[4];
      const double s = std::fabs(ordinary(c)) / 2, t = std::fabs(ordinary(c)) / 2;
      return {a, shifted(b, p + (s * (q - p)) + (t * (r - p)) - b.vertices[c.below(5)])};
    });
    add("opened", [](DrawStream& c) -> Question {
      const Meshd a = lattice_solid(c), b = lattice_solid(c);
      return c.coin() ? Question{a, opened(b, c)} : Question{opened(a, c), b};
    });
    add.unscaled("named_solid", [](DrawStream& c) -> Question {
      const Meshd& a = named_solid(c);
      const Meshd b = dented_tetrahedron_of_24(c);
      const Point3d p = c.one_in(3) ? between_vertices(a, c) : on_a_face_plane(a, c);
      return {a, shifted(b, p - on_a_face_plane(b, c))};
    });
    add.unscaled("reported_manifold_1656",
                 [](DrawStream& c) -> Question { return either_first(reported::manifold_1656(), c); });
    add.unscaled("reported_vcad_6", [](DrawStream& c) -> Question { return either_first(reported::vcad_6(), c); });
    add.unscaled("reported_cgal_9192",
                 [](DrawStream& c) -> Question { return either_first(reported::cgal_9192(integer_in(c, 0, 2)), c); });
    add.unscaled("reported_manifold_676",
                 [](DrawStream& c) -> Question { return either_first(reported::manifold_676(!c.coin()), c); });
    add.unscaled("reported_openscad_3641", [](DrawStream& c) -> Question {
      return either_first(reported::openscad_3641(integer_in(c, 0, 2)), c);
    });
    add.unscaled("needless_vertex_inside", [](DrawStream& c) -> Question {
      // Solids that are apart or touch, but for a needless face of one, which reaches into the other.
      Meshd a = lattice_solid(c);
      const Meshd other = lattice_polyhedron(c);
      const double gap = 12 * up_to(c, 2);
      const Meshd b = shifted(other, {greatest_x(a) - least_x(other) + gap, 0, 0});
      const Face face = a.faces[c.below(a.faces.size())];
      const auto added = static_cast<Index>(a.vertices.size());
      a.vertices.push_back(between_vertices(b, c));
      a.faces.insert(a.faces.end(), {{face.a, face.b, added}, {added, face.b, face.a}});
      return in_either_order(c, a, b);
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd a = solid_of_polygons(c), b = convex_solid_of_polygons(c);
      const Meshd asked = c.one_in(6) ? with_broken_polygons(a, c) : a;
      return {asked, moved(b, c, 12, 3)};
    });
    add.unscaled("within_shells", [](DrawStream& c) -> Question {
      // A solid, or one with a hollow of its own; alone, or after a part that is far away. Its faces lie between
      // two shells or are those of a shell.
      const Meshd shape = around_the_mean(lattice_polyhedron(c)), a = shells(shape, c);
      const double size = one_to(c, 3);
      Meshd b = times(size, shape);
      if (c.coin()) b = together(b, times(size + one_to(c, 4), shape));
      if (c.coin()) b = together(shifted(lattice_polyhedron(c), {0x1p14, 0, 0}), b);
      return in_either_order(c, a, b);
    });
    add.unscaled("body_in_recess", [](DrawStream& c) -> Question {
      const auto [solid, body, middle] = body_in_recess(c);
      return in_either_order(c, solid, body);
    });
    add.unscaled("crossing_boxes", [](DrawStream& c) -> Question {
      const Meshd a = crossing_boxes(c);
      const Point3d from{6 * up_to(c, 7), 6 * up_to(c, 7), 6 * up_to(c, 7)};
      const double size = 6 * one_to(c, 2);
      return in_either_order(c, a, box_mesh(from, from + Vector3d{size, size, size}));
    });
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      // They may lie within the other solid, or widen a box.
      const Meshd a = lattice_solid(c), b = moved(lattice_polyhedron(c), c, 12, 3);
      return in_either_order(c, with_unnamed_vertices(a, between_vertices(b, c), c), b);
    });
  }

  static void repair(Question& question) { make_solid(std::get<0>(question)), make_solid(std::get<1>(question)); }

  /// Two tetrahedra of size 12, the first with a dent or a spike: it and the other's place run over the numbers from 0
  /// in thirds of 12.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd b{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}, {}};
    make_tetrahedron(b);
    return {dented_tetrahedron(12, {4 * x, 4 * y, 4 * z}), shifted(b, {4 * u, 4 * v, 4 * w})};
  }

  /// A corner at the end of a dent: moves the dent.
  static Question map_centre() {
    const Meshd spike{{{2, 2, 2}, {22, 10, 10}, {10, 22, 10}, {10, 10, 22}},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    return {spike, dented_tetrahedron(12, {2, 2, 2})};
  }

  /// Open solids that touch are disjoint.
  static std::optional<PolyhedronPolyhedron> as_open_sets(const PolyhedronPolyhedron& truth, const Question&) {
    if (truth.relation != Contact::touching) return std::nullopt;
    return PolyhedronPolyhedron{Contact::disjoint, truth.decided_by};
  }

  static Hooks<polyhedron_polyhedron> hooks() {
    return {.as_open_sets = as_open_sets,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  template <class Change>
  static Meshd mapped(Meshd mesh, const Change& change) {
    for (Point3d& p : mesh.vertices) p = change(p);
    return mesh;
  }
  static Meshd times(double factor, const Meshd& mesh) {
    return mapped(mesh, [factor](const Point3d& p) { return Point3d{factor * p.x, factor * p.y, factor * p.z}; });
  }
  static double least_x(const Meshd& mesh) {
    return std::min_element(mesh.vertices.begin(), mesh.vertices.end(), is_left)->x;
  }
  static double greatest_x(const Meshd& mesh) {
    return std::max_element(mesh.vertices.begin(), mesh.vertices.end(), is_left)->x;
  }
  static bool is_left(const Point3d& p, const Point3d& q) { return p.x < q.x; }
  /// Faces in any order.
  static Question either_first(const reported::SolidPair& solids, DrawStream& c) {
    const Meshd a = relisted(solids.first, c), b = relisted(solids.second, c);
    return in_either_order(c, a, b);
  }
  static Meshd moved(const Meshd& mesh, DrawStream& c, double unit, int most) {
    return shifted(mesh, {unit * small_integer(c, most), unit * small_integer(c, most), unit * small_integer(c, most)});
  }

  /// A point of the surface of each, or of the planes of its faces, in common.
  template <auto one, auto other>
  static Question touching(DrawStream& c) {
    const Meshd a = one(c), b = other(c);
    const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
    return {a, shifted(b, p - q)};
  }
  static Meshd dented_tetrahedron_of_24(DrawStream&) { return dented_tetrahedron(24, {6, 6, 6}); }

  static std::vector<LatticePoint> cells(DrawStream& c) {
    std::vector<LatticePoint> drawn{{0, 0, 0}};
    for (const LatticePoint& cell : {LatticePoint{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}})
      if (c.coin()) drawn.push_back(cell);
    return drawn;
  }

  /// A ring of cubes, or three in a row, its bars of another width and height.
  static Meshd link(DrawStream& c) {
    std::vector<LatticePoint> of_cells;
    const bool ring = c.below(3) > 0;
    for (std::int64_t i = 0; i < 9; ++i)
      if (ring ? i != 4 : i / 3 == 1) of_cells.push_back({i % 3, i / 3, 0});
    const double bar = 6 * static_cast<double>(2 - c.below(2)), height = 6 * one_to(c, 2);
    const auto narrowed = [bar](double n) { return n == 12 ? bar : n == 24 ? 36 - bar : n; };
    return mapped(cube_surface(of_cells), [=](const Point3d& p) {
      return Point3d{narrowed(p.x), narrowed(p.y), p.z == 0 ? 0 : height};
    });
  }
};

}  // namespace touchstone::catalogue::rows
