// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/place_draws.h"

#include <cmath>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/solid_draws.h"

namespace touchstone::catalogue {

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
