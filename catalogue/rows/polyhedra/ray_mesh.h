// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/figures.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/triangle_draws.h"
#include "catalogue/families/triangles/face_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/polyhedra/ray_mesh.h"
#include "oracle/polyhedra/ray_mesh.h"
#include "reference/polyhedra/ray_mesh.h"
#include "robust/batch/ray_mesh.h"
#include "robust/polyhedra/ray_mesh.h"
#include "robust/prepared/surface.h"

namespace touchstone::catalogue::rows {

struct ray_mesh : signatures::ray_mesh {
  TOUCHSTONE_STAGED_MODULES(ray_mesh)
  TOUCHSTONE_PREPARED(ray_mesh, Surface)
  TOUCHSTONE_ARRAYS(ray_mesh)

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "polyhedra",
      .pages = "9, 54",
      .question = "Where does the ray first meet the faces of a mesh, and how many of them does it meet?",
      .kind = Kind::measure,
      .fields = {"ray", "mesh"},
      .ulps = 31,
      .margin_degree = 2,
      .cost = 60,
      .time = {.robust = Growth::linear, .oracle = Growth::linear, .ask = Growth::linear, .reference = Growth::linear},
      .list_length = 5};

  struct decision {
    static PassageRelation robust(const Question& q) {
      return ::touchstone::robust::ray_mesh_relation(std::get<0>(q), std::get<1>(q));
    }
  };

  static void hard_cases(HardCases<Question>& add) {
    add("on_face_plane", [](DrawStream& c) -> Question {
      const Meshd mesh = lattice_solid(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const Vector3d v = lattice_normal(c, 4);
      return {ray_to(c, p, v), mesh};
    });
    add("through_vertex", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = some_vertex(mesh, c);
      return through(c, p, mesh);
    });
    add("through_two", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = on_a_face_plane(mesh, c), q = c.coin() ? some_vertex(mesh, c) : on_a_face_plane(mesh, c);
      return through_both(c, p, q, mesh);
    });
    add("in_face_plane", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Triangle3d t = triangle_of_face(mesh, c.below(mesh.faces.size()));
      const auto point = [&] {
        const double i = small_integer(c, 2) / 2, j = small_integer(c, 2) / 2;
        return t.a + (i * (t.b - t.a) + j * (t.c - t.a));
      };
      const Point3d p = point(), q = point();
      return through_both(c, p, q, mesh);
    });
    add("starts_on_face_plane", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = on_a_face_plane(mesh, c);
      return {{p, direction(c)}, mesh};
    });
    add("small_lattice", [](DrawStream& c) -> Question {
      const Meshd mesh = small_lattice_faces(c);
      const Point3d p = small_lattice_point(c), q = small_lattice_point(c);
      return through_both(c, p, q, mesh);
    });
    add("through_one_point", [](DrawStream& c) -> Question {
      // Up to eight faces of any planes, around the point or near it, and the ray through it.
      const Point3d p = lattice_point_in_space(c, 6);
      const auto triangles = one_by_one(c, 8, [&p](DrawStream& d) {
        return LatticePlane{p, lattice_normal(d, 3), lattice_normal(d, 3)}.triangle(d);
      });
      return {ray_to(c, p, lattice_normal(c, 3)), mesh_of_triangles(triangles)};
    });
    add("rounded_ties", [](DrawStream& c) -> Question {
      // Across the axis, an ulp or a few apart, where quotients by 1.5 are farther apart than their rounding is fine.
      const auto triangles = one_by_one(c, 6, [](DrawStream& d) {
        const double x = ulps_apart(d, 1.75, 4), y = small_integer(d, 1);
        return Triangle3d{{x, -2, y - 2}, {x, 2, -2}, {x, 0, 2}};
      });
      return {{{0, 0, 0}, {1.5, 0, 0}}, mesh_of_triangles(triangles)};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c, 4);
      Meshd mesh =
          mesh_of_triangles(one_by_one(c, 4, [&line](DrawStream& d) { return line.triangle_without_area(d); }));
      if (c.coin()) mesh.faces.push_back({1, c.coin() ? Index{1} : Index{0}, 1});
      const Point3d p = line.on_line(c);
      return {ray_to(c, p, c.coin() ? line.v : line.u), mesh};
    });
    add("few_faces", [](DrawStream& c) -> Question {
      Meshd mesh = lattice_solid(c);
      const Point3d p = on_a_face_plane(mesh, c);
      mesh.faces.resize(c.below(4));
      return {ray_to(c, p, lattice_normal(c, 2)), mesh};
    });
    add("listed_twice", [](DrawStream& c) -> Question {
      const Meshd mesh = with_face_listed_twice(lattice_solid(c), c);
      const Point3d p = on_a_face_plane({mesh.vertices, {mesh.faces.back()}}, c);
      return through(c, p, mesh);
    });
    add("far_from_origin", [](DrawStream& c) -> Question {
      const Vector3d by = far_displacement(c);
      const Meshd mesh = shifted(some_faces(c), by);
      const Point3d p = on_a_face_plane(mesh, c);
      return through(c, p, mesh);
    });
    add("nearly_along_axis", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = some_vertex(mesh, c);
      const double least = power_of_two(c, -44, -20), y = c.coin() ? least : -least, z = c.coin() ? least : 0;
      return {ray_to(c, p, {1, y, z}), mesh};
    });
    add("from_far_away", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const Vector3d v = lattice_normal(c, 2);
      return {{along(p, -power_of_two(c, 20, 44), v), v}, mesh};
    });
    add("direction_of_any_size", [](DrawStream& c) -> Question {
      Question question = some_question(c);
      Vector3d& v = std::get<0>(question).direction;
      v = scaled(v, integer_in(c, -1060, 979));
      return question;
    });
    add("rounded_onto_edge", [](DrawStream& c) -> Question {
      const Meshd mesh = ordinary_solid(c);
      const Triangle3d t = triangle_of_face(mesh, c.below(mesh.faces.size()));
      const Point3d p = ordinary_point_in_space(c), q = t.a + std::fabs(ordinary(c)) * (t.b - t.a);
      return {c.coin() ? Ray3d{q, p - q} : Ray3d{p, q - p}, mesh};
    });
    add("stretched", [](DrawStream& c) -> Question {
      auto [ray, mesh] = some_question(c);
      Stretch{c, {0, 54, 60, 255, -64, -170, 300, -300}}(ray, mesh);
      return {ray, mesh};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      auto [ray, mesh] = some_question(c);
      const auto least = [](auto& p) { p = scaled(p, -1074); };
      change_each(mesh, least), change_each(ray, least);
      return {ray, mesh};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = huge_or_small_point(c), q = huge_or_small_point(c);
      const auto draw = [](DrawStream& d) { return triangle_of(d, huge_or_small_point); };
      return {{p, {q.x, q.y, q.z}}, mesh_of_triangles(one_by_one(c, 4, draw))};
    });
    add("opened", [](DrawStream& c) -> Question {
      // Mostly an open mesh; sometimes a face that names a vertex twice.
      const Meshd mesh = opened(lattice_solid(c), c);
      const Point3d p = some_vertex(mesh, c);
      return through(c, p, mesh);
    });
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      const Meshd solid = lattice_solid(c);
      const Point3d p = between_vertices(solid, c);
      const Meshd mesh = with_unnamed_vertices(solid, p, c);
      return through(c, p, mesh);
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = solid_of_polygons(c);
      const Point3d p = c.coin()   ? between_vertices(mesh, c)
                        : c.coin() ? on_a_face_plane(mesh, c)
                                   : some_vertex(mesh, c);
      return through(c, p, c.one_in(6) ? with_broken_polygons(mesh, c) : mesh);
    });
    add.unscaled("named_solid", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_solid(c);
      const Point3d p = on_a_face_plane(mesh, c), q = c.coin() ? between_vertices(mesh, c) : some_vertex(mesh, c);
      return through_both(c, p, q, mesh);
    });
    add.unscaled("long_mesh", [](DrawStream& c) -> Question {
      // To one of the last vertices for the most part, whose faces are late in the list.
      const Meshd& mesh = long_solid(c);
      const Point3d p = beside(mesh.vertices[late_index(mesh.vertices.size(), c)], c);
      return through(c, p, mesh);
    });
  }

  static void repair(Question& question) { make_strip(std::get<1>(question)); }

  /// From a point of a grid in thirds of 12 in a direction of integers, at a tetrahedron of size 12 with a dent.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    return {{{4 * x - 4, 4 * y, 4 * z}, {u, v - 1, w - 1}}, dented_tetrahedron(12, {2, 2, 2})};
  }

  /// A ray along the diagonal through the dent.
  static Question map_centre() { return {{{-4, -4, -4}, {1, 1, 1}}, dented_tetrahedron(12, {2, 2, 2})}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The face that is met first.
  static void draw(Drawing& drawing, const Question& question, const RayMesh<double>& truth) {
    const auto& [ray, mesh] = question;
    catalogue::draw(drawing, "ray", ray, false), catalogue::draw(drawing, "mesh", mesh, false);
    if (!truth.first || truth.first->face >= mesh.faces.size()) return;
    catalogue::draw(drawing, "face", triangle_of_face(mesh, truth.first->face), true);
    catalogue::draw(drawing, "point", truth.first->point, true);
  }

  static Hooks<ray_mesh> hooks() {
    return {.repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::affine, .scales = true}};
  }

 private:
  /// A ray in any direction through the point.
  static Question through(DrawStream& c, const Point3d& p, const Meshd& mesh) {
    const Vector3d v = direction(c);
    return {ray_to(c, p, v), mesh};
  }
  static Question some_question(DrawStream& c) {
    const Meshd mesh = some_faces(c);
    const Point3d p = on_a_face_plane(mesh, c);
    return through(c, p, mesh);
  }
  /// From one point to the other, or along an axis if they are one.
  static Question through_both(DrawStream& c, const Point3d& p, const Point3d& q, const Meshd& mesh) {
    return {ray_to(c, p, q == p ? Vector3d{0, 1, 0} : q - p), mesh};
  }

  /// Along an axis, or between.
  static Vector3d direction(DrawStream& c) {
    if (c.coin()) return lattice_normal(c, 3);
    const std::uint64_t axis = c.below(3);
    const double step = either_sign(c);
    return {axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0};
  }
  /// From before the point, from it, or from behind, along the way or against it.
  static Ray3d ray_to(DrawStream& c, const Point3d& x, const Vector3d& displacement) {
    const double before = small_integer(c, 2), length = one_to(c, 3);
    return {along(x, -12 * before - 12, displacement), (either_sign(c) * length) * displacement};
  }
};

}  // namespace touchstone::catalogue::rows
