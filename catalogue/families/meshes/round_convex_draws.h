// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <tuple>

#include "catalogue/families/meshes/convex_pair_draws.h"
#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/round_draws.h"

/// Hard cases of a round solid and a convex mesh.
namespace touchstone::catalogue {

using BallAndMesh = std::tuple<Sphere3d, Meshd>;

/// At a right angle to a displacement, and not 0.
inline Vector3d any_across(DrawStream& c, const Vector3d& v) {
  const Vector3d drawn = lattice_across(c, v);
  if (dot(drawn, drawn) > 0) return drawn;
  return v.x == 0 && v.y == 0 ? Vector3d{1, 0, 0} : Vector3d{-v.y, v.x, 0};
}

/// A solid all of which is behind the plane through a vertex, an edge or a face of it, at a right angle to a step of
/// integer length: the ball around the end of the step reaches that vertex, edge or face, or nearly.
inline BallAndMesh tangent_to_mesh(DrawStream& c) {
  const Step step = integer_step(c);
  const Vector3d out = step.displacement, across = any_across(c, out), drawn = any_across(c, out),
                 normal = cross(across, drawn), other = dot(normal, normal) > 0 ? drawn : cross(out, across);
  const Point3d p = lattice_point_in_space(c, 16);
  const double i = up_to(c, 1), j = up_to(c, 1);
  const Vector3d edge = 4.0 * across - (1 - i) * out, side = 4.0 * other - (1 - j) * out;
  const Meshd mesh = tetrahedron_over({{p, p + edge, p + side, p + -2.0 * out}});
  const Point3d on = c.coin() ? p : p + (i * across + j * other);
  return {{on + out, reaching(c, step.length)}, mesh};
}

/// Around a vertex, the middle of an edge or a face, or what is beyond them, some steps away.
inline BallAndMesh aimed_at(const Meshd& mesh, DrawStream& c) {
  const Point3d p = on_a_face_plane(mesh, c);
  const double steps = small_integer(c, 1);
  const Vector3d way = steps * lattice_normal(c, 4);
  return {{p + way, near_length(c, way)}, mesh};
}

/// Calls add(name, draw) for each.
template <class Add>
void add_balls_and_meshes(const Add& add) {
  add("tangent", [](DrawStream& c) -> BallAndMesh { return tangent_to_mesh(c); });
  add("nearly_tangent", [](DrawStream& c) -> BallAndMesh { return aimed_at(lattice_polyhedron(c), c); });
  add("center_inside", [](DrawStream& c) -> BallAndMesh {
    const Meshd mesh = lattice_polyhedron(c);
    const Point3d p = between_vertices(mesh, c), q = mesh.vertices[c.below(mesh.vertices.size())];
    return {{{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2}, up_to(c, 2)}, mesh};
  });
  add("point_ball", [](DrawStream& c) -> BallAndMesh {
    // On the surface, in the solid, or next to them.
    const Meshd mesh = lattice_polyhedron(c);
    const Point3d p = c.coin() ? on_a_face_plane(mesh, c) : between_vertices(mesh, c);
    return {{c.coin() ? p : beside(p, c), zero(c)}, mesh};
  });
  add("flat_and_repeated_vertices", [](DrawStream& c) -> BallAndMesh {
    const Meshd mesh = with_repeated_vertex(with_flat_vertex(lattice_polyhedron(c), c), c);
    return aimed_at(mesh, c);
  });
  add("needles", [](DrawStream& c) -> BallAndMesh {
    auto [ball, mesh] = aimed_at(lattice_polyhedron(c), c);
    const double length = scaled_up(c, 8, 60);
    for (Point3d& p : mesh.vertices) p.x = p.x * length;
    return {ball, mesh};
  });
  add("near_root", [](DrawStream& c) -> BallAndMesh {
    // The center is beyond an edge by (r, r), so its distance is r times the root of 2, which is irrational.
    const auto [x, r] = near_root(c);
    const double far = one_to(c, 8);
    return {{{r, r, integer(c, 10)}, x}, tetrahedron_over({{{0, 0, -4096}, {0, 0, 4096}, {-far, 0, 0}, {0, -far, 0}}})};
  });
  add("rounded_tangent", [](DrawStream& c) -> BallAndMesh {
    const Meshd mesh = tetrahedron_of(c, ordinary_point_in_space);
    const Vector3d way = ordinary_point_in_space(c) - Point3d{0, 0, 0};
    return {{mesh.vertices[0] + way, near_length(c, way)}, mesh};
  });
  add("stretched", [](DrawStream& c) -> BallAndMesh {
    auto [ball, mesh] = tangent_to_mesh(c);
    Stretch{c}(ball.center, mesh);
    return {ball, mesh};
  });
  add("subnormal", [](DrawStream& c) -> BallAndMesh {
    // Integers times the least number, or a few times that: their products underflow.
    auto [ball, mesh] = tangent_to_mesh(c);
    const int down = -1074 + integer_in(c, 0, 60);
    for (Point3d& p : mesh.vertices) p = scaled(p, down);
    return {{scaled(ball.center, down), std::ldexp(ball.radius, down)}, mesh};
  });
  add("moderate_ends", [](DrawStream& c) -> BallAndMesh {
    // The greatest and the least numbers that the filter takes, and the next beyond them; tangent, or far from that.
    const double large = power_of_two(c, 29, 31), least = power_of_two(c, -32, -29), side = small_integer(c, 1);
    const double far = c.coin() ? 0 : large / 2, r = c.coin() ? least : large;
    return {{{large + far + least, side * least, 0}, r},
            tetrahedron_over({{{large, 0, 0}, {-large, 0, 0}, {0, large, 0}, {0, least, 1}}})};
  });
  add("whole_range", [](DrawStream& c) -> BallAndMesh {
    const Point3d p = point_of_full_range(c);
    const double r = std::fabs(of_full_range(c));
    return {{p, r}, tetrahedron_of(c, point_of_full_range)};
  });
  add("either_zero", [](DrawStream& c) -> BallAndMesh {
    const Point3d p = zero_point(c), q = zero_point(c), at = zero_point(c);
    const double x = small_integer(c, 2), r = c.coin() ? -0.0 : up_to(c, 1);
    return {{{x == 0 ? at.x : x, at.y, at.z}, r},
            tetrahedron_over({{p, {-1, q.y, q.z}, {q.x, -1, p.z}, {p.x, p.y, -1}}})};
  });
  add("typed_touch", [](DrawStream& c) -> BallAndMesh {
    // As typed the ball reaches a vertex, in front of the solid by (3, 4) k.
    const double k = one_to(c, 9), m = one_to(c, 9);
    return {{{(m + 3 * k) / 10, (m + 4 * k) / 10, 0}, 5 * k / 10},
            tetrahedron_over({{{m / 10, m / 10, 0}, {-0.8, -0.1, 0}, {-0.1, -0.8, 0}, {-0.3, -0.3, 0.7}}})};
  });
  add("broken", [](DrawStream& c) -> BallAndMesh {
    auto [ball, mesh] = aimed_at(lattice_polyhedron(c), c);
    return {ball, broken(mesh, c)};
  });
  add("negative_radius", [](DrawStream& c) -> BallAndMesh {
    auto [ball, mesh] = aimed_at(lattice_polyhedron(c), c);
    return {{ball.center, small_integer(c, 3)}, mesh};
  });
}

using CapsuleAndMesh = std::tuple<Capsule3d, Meshd>;

/// Calls add(name, draw) for each.
template <class Add>
void add_capsules_and_meshes(const Add& add) {
  add("tangent_along", [](DrawStream& c) -> CapsuleAndMesh {
    // Along a face or an edge, or across an edge.
    const auto [ball, mesh] = tangent_to_mesh(c);
    const auto& [p, q, r, behind] = std::tie(mesh.vertices[0], mesh.vertices[1], mesh.vertices[2], mesh.vertices[3]);
    const Vector3d v = c.coin() ? q - p : any_across(c, behind - p);
    const double i = small_integer(c, 2), j = small_integer(c, 2);
    return {{{along(ball.center, i, v), along(ball.center, j, v)}, ball.radius}, mesh};
  });
  add("crossing", [](DrawStream& c) -> CapsuleAndMesh {
    const Meshd mesh = lattice_polyhedron(c);
    const Point3d p = between_vertices(mesh, c);
    const Segment3d segment = segment_through(c, p, lattice_normal(c, 12));
    return {{segment, up_to(c, 1)}, mesh};
  });
  add("segment_on_surface", [](DrawStream& c) -> CapsuleAndMesh {
    // It has a point of the surface, or two.
    const Meshd mesh = lattice_polyhedron(c);
    const Point3d p = on_a_face_plane(mesh, c);
    const Segment3d segment =
        c.coin() ? Segment3d{p, on_a_face_plane(mesh, c)} : segment_through(c, p, lattice_normal(c, 4));
    return {{segment, zero(c)}, mesh};
  });
  add_balls_and_meshes([&add]<class Draw>(const char* family, const Draw&) {
    add(family, [](DrawStream& c) -> CapsuleAndMesh { return ending_in(Draw()(c), c); });
  });
}

/// The same of long meshes and of polygons: calls add(name, draw) for each.
template <class Add>
void add_balls_and_long_meshes(const Add& add) {
  add("late_vertices", [](DrawStream& c) -> BallAndMesh {
    const Meshd mesh = with_late_corners(c);
    const Point3d p = mesh.vertices[mesh.faces[0].a];
    const Vector3d way = lattice_normal(c, 10);
    return {{p + way, near_length(c, way)}, mesh};
  });
  add("named_mesh", [](DrawStream& c) -> BallAndMesh { return aimed_at(named_mesh(c), c); });
  add("polygons", [](DrawStream& c) -> BallAndMesh {
    const auto [ball, mesh] = aimed_at(convex_solid_of_polygons(c), c);
    return {ball, c.one_in(6) ? with_broken_polygons(mesh, c) : mesh};
  });
}

}  // namespace touchstone::catalogue
