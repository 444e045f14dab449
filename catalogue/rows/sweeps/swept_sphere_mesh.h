// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/draw/motions.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/triangles/face_draws.h"
#include "catalogue/families/triangles/round_triangle_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/open_sets.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/sweeps/swept_sphere_mesh.h"
#include "oracle/sweeps/swept_sphere_mesh.h"
#include "oracle/sweeps/swept_sphere_triangle.h"
#include "reference/sweeps/swept_sphere_mesh.h"
#include "robust/prepared/surface.h"
#include "robust/sweeps/swept_sphere_mesh.h"

namespace touchstone::catalogue::rows {

struct swept_sphere_mesh : signatures::swept_sphere_mesh {
  TOUCHSTONE_STAGED_MODULES(swept_sphere_mesh)
  TOUCHSTONE_PREPARED(swept_sphere_mesh, Surface)
  using decision = NoDecision;

  static constexpr Metadata metadata{
      .name = name,
      .chapter = "sweeps",
      .pages = "23, 54",
      .question = "When in a step does a moving ball first meet the faces of a mesh, and which of them?",
      .kind = Kind::measure,
      .fields = {"sphere", "velocity", "mesh"},
      .ulps = 53,
      .margin_degree = 2,
      .cost = 60,
      .time = {.robust = Growth::linear, .oracle = Growth::linear, .ask = Growth::linear, .reference = Growth::linear},
      .list_length = 5};

  static void hard_cases(HardCases<Question>& add) {
    add("onto_face_plane", onto_faces);
    add("onto_vertex", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = some_vertex(mesh, c);
      return towards(c, p, mesh);
    });
    add("within", [](DrawStream& c) -> Question {
      // From the middle of two vertices to that of others.
      const Meshd mesh = lattice_solid(c);
      const Point3d p = between_vertices(mesh, c), q = between_vertices(mesh, c);
      return {{p, up_to(c, 6)}, q - p, mesh};
    });
    add("starts_in_contact", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const Vector3d v = lattice_normal(c, 4);
      return {{p, up_to(c, 24)}, v, mesh};
    });
    add("at_rest", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = on_a_face_plane(mesh, c);
      const double r = up_to(c, 12), x = zero(c), y = zero(c);
      return {{p, r}, {x, y, zero(c)}, mesh};
    });
    add("grazes_vertex", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Step step = integer_step(c);
      const Vector3d v = lattice_across(c, step.displacement);
      const double before = one_to(c, 2);
      const Point3d p = along(some_vertex(mesh, c), -before, v) + step.displacement;
      return {{p, reaching(c, step.length)}, one_to(c, 4) * v, mesh};
    });
    add("slides_over", [](DrawStream& c) -> Question {
      // Over faces of one plane, as far from it as the radius, or down to it.
      const IntegerAcross across = IntegerAcross::of(c);
      const LatticePlane plane{lattice_point_in_space(c, 16), across.u, across.v};
      const Meshd mesh = mesh_of_triangles(one_by_one(c, 5, [&plane](DrawStream& d) { return plane.triangle(d); }));
      const double high = one_to(c, 2), i = small_integer(c, 4), j = small_integer(c, 4);
      const Point3d p = along(plane.point(c), high, across.displacement);
      return {{p, reaching(c, across.length)}, i * across.u + j * across.v + (1 - high) * across.displacement, mesh};
    });
    add("rounded_ties", [](DrawStream& c) -> Question {
      // Across the axis, an ulp or a few apart, where quotients by 3 are farther apart than their rounding is fine.
      const auto triangles = one_by_one(c, 6, [](DrawStream& d) {
        const double x = ulps_apart(d, 1.75, 4), y = small_integer(d, 1);
        return Triangle3d{{x, -2, y - 2}, {x, 2, -2}, {x, 0, 2}};
      });
      return {{{0, 0, 0}, up_to(c, 3) / 4}, {3, 0, 0}, mesh_of_triangles(triangles)};
    });
    add("irrational_ties", [](DrawStream& c) -> Question {
      // Edges at both sides of the way, as near to it as others but for ulps.
      const double r = 2 + up_to(c, 4);
      const auto triangles = one_by_one(c, 6, [](DrawStream& d) {
        const double x = ulps_apart(d, 8, 2), side = either_sign(d), y = side * ulps_apart(d, 1, 6),
                     back = one_to(d, 3);
        return Triangle3d{{x, y, -4}, {x, y, 4}, {x + back, 2 * y, 0}};
      });
      return {{{0, 0, 0}, r}, {16, 0, 0}, mesh_of_triangles(triangles)};
    });
    add("small_lattice", [](DrawStream& c) -> Question {
      const Meshd mesh = small_lattice_faces(c);
      const Point3d p = small_lattice_point(c), q = small_lattice_point(c);
      return {{p, up_to(c, 4) / 4}, 2.0 * (q - p), mesh};
    });
    add("no_area", [](DrawStream& c) -> Question {
      const LatticePlane line = LatticePlane::of(c, 4);
      Meshd mesh =
          mesh_of_triangles(one_by_one(c, 4, [&line](DrawStream& d) { return line.triangle_without_area(d); }));
      if (c.coin()) mesh.faces.push_back({1, c.coin() ? Index{1} : Index{0}, 1});
      const Point3d p = line.on_line(c);
      return towards(c, p, mesh);
    });
    add("few_faces", [](DrawStream& c) -> Question {
      auto [ball, v, mesh] = onto_faces(c);
      mesh.faces.resize(c.below(4));
      return {ball, v, mesh};
    });
    add("listed_twice", [](DrawStream& c) -> Question {
      const Meshd mesh = with_face_listed_twice(lattice_solid(c), c);
      const Point3d p = on_a_face_plane({mesh.vertices, {mesh.faces.back()}, {}}, c);
      return towards(c, p, mesh);
    });
    add("far_from_origin", [](DrawStream& c) -> Question {
      const Vector3d by = far_displacement(c);
      const auto [ball, v, mesh] = onto_faces(c);
      return {{ball.center + by, ball.radius}, v, shifted(mesh, by)};
    });
    add("from_far_away", [](DrawStream& c) -> Question {
      const auto [ball, v, mesh] = onto_faces(c);
      const double far = power_of_two(c, 10, 44);
      return {{along(ball.center, -far, v), ball.radius}, 2 * far * v, mesh};
    });
    add("large_ball", [](DrawStream& c) -> Question {
      // From next to the mesh; its radius is past the digits of floats.
      const Meshd mesh = some_faces(c);
      const Point3d p = some_vertex(mesh, c);
      const double r = power_of_two(c, 10, 62), away = small_integer(c, 4), x = small_integer(c, 2);
      return {{{p.x - r - away, p.y + x, p.z}, r}, {up_to(c, 8), x, 0}, mesh};
    });
    add("velocity_of_any_size", [](DrawStream& c) -> Question {
      const auto [ball, v, mesh] = onto_faces(c);
      return {ball, scaled(v, integer_in(c, -1060, 979)), mesh};
    });
    add("nearly_along_axis", [](DrawStream& c) -> Question {
      const Meshd mesh = some_faces(c);
      const Point3d p = some_vertex(mesh, c);
      const double least = power_of_two(c, -44, -20), y = c.coin() ? least : -least, far = 64 * one_to(c, 4);
      const Vector3d v{1, y, c.coin() ? least : 0};
      return {{along(p, -far, v), up_to(c, 8)}, 2 * far * v, mesh};
    });
    add("mapped", [](DrawStream& c) -> Question {
      auto [ball, v, mesh] = onto_faces(c);
      Point3d p = ball.center, q = p + v;
      map_linearly(c, p, q, mesh);
      return {{p, ball.radius}, q - p, mesh};
    });
    add("stretched", [](DrawStream& c) -> Question {
      auto [ball, v, mesh] = onto_faces(c);
      Stretch{c, {0, 54, 60, 255, -64, -170, 300, -300, 1015, -1074}}(ball.center, v, mesh);
      return {ball, v, mesh};
    });
    add("subnormal", [](DrawStream& c) -> Question {
      auto [ball, v, mesh] = onto_faces(c);
      const auto least = [](auto& part) { part = scaled(part, -1074); };
      change_each(mesh, least), least(ball.center), least(v);
      return {{ball.center, std::ldexp(ball.radius, -1074)}, v, mesh};
    });
    add("whole_range", [](DrawStream& c) -> Question {
      const Point3d p = point_of_full_range(c), q = point_of_full_range(c);
      const double r = std::fabs(of_full_range(c));
      return {{p, r}, {q.x, q.y, q.z}, tetrahedron_of(c, point_of_full_range)};
    });
    add("either_zero", [](DrawStream& c) -> Question {
      const Point3d o = zero_point(c), p = zero_point(c), q = zero_point(c);
      const double r = c.coin() ? -0.0 : up_to(c, 1);
      const double x = small_integer(c, 2);
      return {{{p.x, x, q.x}, r}, {q.y, -x, o.x}, tetrahedron_over({{o, {1, p.y, q.z}, {q.x, 1, o.z}, {p.z, o.y, 1}}})};
    });
    add("full_mantissa", [](DrawStream& c) -> Question {
      const Meshd mesh = ordinary_solid(c);
      const Point3d p = ordinary_point_in_space(c), q = ordinary_point_in_space(c);
      return {{p, std::fabs(ordinary(c)) / 4}, q - p, mesh};
    });
    add.unscaled("unnamed_vertices", [](DrawStream& c) -> Question {
      const auto [ball, v, mesh] = onto_faces(c);
      return {ball, v, with_unnamed_vertices(mesh, ball.center, c)};
    });
    add.unscaled("polygons", [](DrawStream& c) -> Question {
      const Meshd mesh = solid_of_polygons(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : some_vertex(mesh, c);
      return towards(c, p, c.one_in(6) ? with_broken_polygons(mesh, c) : mesh);
    });
    add.unscaled("named_solid", [](DrawStream& c) -> Question {
      const Meshd& mesh = named_solid(c);
      const Point3d p = c.coin() ? between_vertices(mesh, c) : on_a_face_plane(mesh, c);
      return towards(c, p, mesh);
    });
    add.unscaled("long_mesh", [](DrawStream& c) -> Question {
      // To one of the last vertices for the most part, whose faces are late in the list.
      const Meshd& mesh = long_solid(c);
      const Point3d p = beside(mesh.vertices[late_index(mesh.vertices.size(), c)], c);
      return towards(c, p, mesh);
    });
  }

  static void repair(Question& question) { repair_radii(question), make_strip(std::get<2>(question)); }

  /// A ball of radius 2 on a grid in thirds of 12, and a tetrahedron of size 12 with a dent.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    return {{{4 * x - 4, 4 * y, 4 * z}, 2}, {4 * u, 4 * v - 4, 4 * w - 4}, dented_tetrahedron(12, {2, 2, 2})};
  }

  /// Along the diagonal into the dent.
  static Question map_centre() { return {{{-4, -4, -4}, 1}, {8, 8, 8}, dented_tetrahedron(12, {2, 2, 2})}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {0, 1}; }

  /// The open ball meets no face that is only grazed, during the step or at its ends.
  static std::optional<FirstFaceContact<TrueNumber>> as_open_sets(const FirstFaceContact<TrueNumber>& truth,
                                                                  const Question& question) {
    if (truth.relation != HitRelation::hit) return std::nullopt;
    const auto& [sphere, velocity, mesh] = question;
    FirstFaceContact<TrueNumber> open{HitRelation::never, {}, {}};
    for (Index i = 0; i < mesh.faces.size(); ++i) {
      const auto one = ::touchstone::oracle::swept_sphere_triangle(sphere, velocity, triangle_of_face(mesh, i));
      if (!one.answer.t || sgn(*one.margin) == 0 || (open.t && *open.t <= *one.answer.t)) continue;
      open = {HitRelation::hit, one.answer.t, i};
    }
    if (open.t == truth.t && open.face == truth.face) return std::nullopt;
    return open;
  }

  /// The step: the ball at its start, at the first contact and at its end; and the face.
  static void draw(Drawing& drawing, const Question& question, const FirstFaceContact<double>& truth) {
    draw_step(drawing, "sphere", "mesh", question, truth.t);
    const Meshd& mesh = std::get<2>(question);
    if (truth.face && *truth.face < mesh.faces.size())
      catalogue::draw(drawing, "face", triangle_of_face(mesh, *truth.face), true);
  }

  static Hooks<swept_sphere_mesh> hooks() {
    return {.as_open_sets = as_open_sets,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// Towards the point, up to it or past it.
  static Question towards(DrawStream& c, const Point3d& p, const Meshd& mesh) {
    const Vector3d way = lattice_normal(c, 4);
    const double before = 4 * up_to(c, 3), steps = 4 * up_to(c, 6), r = up_to(c, 8);
    return {{along(p, -before, way), r}, steps * way, mesh};
  }
  static Question onto_faces(DrawStream& c) {
    const Meshd mesh = some_faces(c);
    const Point3d p = on_a_face_plane(mesh, c);
    return towards(c, p, mesh);
  }
};

}  // namespace touchstone::catalogue::rows
