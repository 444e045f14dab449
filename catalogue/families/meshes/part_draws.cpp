// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/part_draws.h"

#include <array>
#include <cmath>
#include <vector>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/lattice_hull.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/numbers.h"

namespace touchstone::catalogue {
namespace {

Meshd in_one_mesh(const std::vector<Meshd>& parts) {
  Meshd mesh;
  for (const Meshd& part : parts) mesh = together(mesh, part);
  return mesh;
}

/// A cube, an octahedron or a tetrahedron, from -1 to 1 on every axis.
Meshd unit_body(DrawStream& draws) {
  switch (draws.below(3)) {
    case 0: return box_mesh({-1, -1, -1}, {1, 1, 1});
    case 1: return lattice_hull({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
    default: return lattice_hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  }
}

}  // namespace

Meshd box_mesh(const Point3d& min, const Point3d& max) {
  Meshd mesh = cube_surface({{0, 0, 0}});
  for (Point3d& p : mesh.vertices) p = {p.x == 0 ? min.x : max.x, p.y == 0 ? min.y : max.y, p.z == 0 ? min.z : max.z};
  return mesh;
}

Meshd shells(const Meshd& shape, DrawStream& draws) {
  std::vector<Meshd> parts;
  for (std::uint64_t left = 3 + draws.below(3); left > 0; --left) {
    const double size = 2 * static_cast<double>(parts.size() + 1);
    Meshd shell = shape;
    for (Point3d& p : shell.vertices) p = {size * p.x, size * p.y, size * p.z};
    if (draws.coin()) turn_inside_out(shell);
    parts.push_back(shell);
  }
  return in_one_mesh(shuffled(parts, draws));
}

BodyInRecess body_in_recess(DrawStream& draws) {
  BodyInRecess drawn{{}, {}, {18, 18, 6}};
  switch (draws.below(3)) {
    case 0:
      drawn.solid = together(box_mesh({0, 0, 0}, {36, 36, 36}), box_mesh({12, 12, 12}, {24, 24, 24}));
      drawn.middle.z = 18;
      break;
    case 1: drawn.solid = cube_surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}); break;
    default:
      drawn.solid =
          cube_surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}});
  }
  drawn.body = unit_body(draws);
  const double size = std::array{3.0, 6.0, 4.0, 9.0}[draws.below(4)];
  const auto off = [&draws] { return draws.coin() ? 3 * small_integer(draws, 2) : 0.0; };
  const double x = off(), y = off(), z = off();
  const auto& [at_x, at_y, at_z] = drawn.middle;
  for (Point3d& p : drawn.body.vertices) p = {at_x + x + size * p.x, at_y + y + size * p.y, at_z + z + size * p.z};
  return drawn;
}

Meshd crossing_boxes(DrawStream& draws) {
  std::vector<Meshd> boxes;
  for (std::uint64_t left = 2 + draws.below(2); left > 0; --left) {
    const auto from = [&draws] { return 12 * up_to(draws, 2); };
    const double x = from(), y = from(), z = from();
    const auto to = [&draws] { return 36 + 12 * up_to(draws, 2); };
    const double u = to(), v = to(), w = to();
    boxes.push_back(box_mesh({x, y, z}, {u, v, w}));
  }
  return in_one_mesh(boxes);
}

Meshd with_unnamed_vertices(Meshd mesh, const Point3d& place, DrawStream& draws) {
  for (std::uint64_t left = 1 + draws.below(3); left > 0; --left) {
    const auto far = [&draws] { return 1200 * small_integer(draws, 2); };
    const double x = far(), y = far(), z = far();
    const Meshd vertex{{draws.coin() ? Point3d{x, y, z} : place}, {}};
    mesh = draws.coin() ? together(vertex, mesh) : together(mesh, vertex);
  }
  return mesh;
}

MeshAndPoint place_at_tetrahedra(DrawStream& draws) {
  const Meshd mesh = tetrahedra_together(draws);
  const Point3d p = draws.coin() ? on_a_face_plane(mesh, draws) : between_vertices(mesh, draws);
  return {mesh, {p.x + 4 * small_integer(draws, 2), p.y, p.z}};
}

MeshAndPoint place_at_needless_faces(DrawStream& draws) {
  Meshd mesh = lattice_solid(draws);
  for (std::uint64_t left = 1 + draws.below(3); left > 0; --left) {
    for (Point3d& p : mesh.vertices) p = {6 * p.x, 6 * p.y, 6 * p.z};
    mesh = with_needless_faces(mesh, draws);
  }
  const Point3d p = mesh.vertices[draws.coin() ? 0 : mesh.vertices.size() - 1], q = on_a_face_plane(mesh, draws);
  return {mesh, {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2}};
}

MeshAndPoint place_at_face_listed_twice(DrawStream& draws) {
  const Meshd mesh = with_face_listed_twice(lattice_solid(draws), draws);
  const Point3d p = on_a_face_plane({mesh.vertices, {mesh.faces.back()}}, draws);
  const double displacement = draws.one_in(3) ? 4 * small_integer(draws, 4) : 0;
  return {mesh, {p.x + displacement, p.y, p.z}};
}

MeshAndPoint rounded_place_on_face(DrawStream& draws) {
  const Meshd mesh = ordinary_solid(draws);
  const auto &a = mesh.vertices[1], &b = mesh.vertices[2], &d = mesh.vertices[4];
  const double s = std::fabs(ordinary(draws)) / 2, t = std::fabs(ordinary(draws)) / 2;
  return {mesh, a + (s * (b - a)) + (t * (d - a))};
}

MeshAndPoint place_in_shells(DrawStream& draws) {
  const Meshd shape = around_the_mean(lattice_polyhedron(draws)), mesh = shells(shape, draws);
  const Point3d p = on_a_face_plane(shape, draws);
  const auto size = up_to(draws, 7);
  return {mesh, {size * p.x, size * p.y, size * p.z}};
}

MeshAndPoint place_in_recess(DrawStream& draws) {
  const auto [solid, body, middle] = body_in_recess(draws);
  const Meshd mesh = draws.coin() ? together(body, solid) : together(solid, body);
  const Vector3d off{3 * small_integer(draws, 4), 3 * small_integer(draws, 4), 3 * small_integer(draws, 4)};
  return {mesh, (draws.one_in(3) ? on_a_face_plane(body, draws) : middle) + off};
}

MeshAndPoint place_in_crossing_boxes(DrawStream& draws) {
  const Meshd mesh = crossing_boxes(draws);
  const auto coordinate = [&draws] { return 6 * static_cast<double>(2 + draws.below(7)); };
  return {mesh, {coordinate(), coordinate(), coordinate()}};
}

MeshAndPoint place_at_long_solid(DrawStream& draws) {
  const Meshd& mesh = long_solid(draws);
  const Point3d& p = mesh.vertices[late_index(mesh.vertices.size(), draws)];
  return {mesh,
          {p.x + 6 * small_integer(draws, 1), p.y + 6 * small_integer(draws, 1), p.z + 6 * small_integer(draws, 1)}};
}

}  // namespace touchstone::catalogue
