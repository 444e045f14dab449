// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <tuple>

#include "catalogue/families/space_draws.h"
#include "geometry/polyhedra.h"

/// Closed convex meshes, drawn from a draw stream; the simplest is a tetrahedron.
namespace touchstone::catalogue {

/// Coordinates are multiples of 12 of at most 48, so that middles of edges and of faces are integers: a tetrahedron, a
/// cube, an octahedron, or the hull of some lattice points. Faces in any order, from any corner on, perhaps all turned
/// inside out.
Meshd lattice_polyhedron(DrawStream& draws);

/// One of those that test vectors name (catalogue/families/meshes/named_meshes.h).
const Meshd& named_mesh(DrawStream& draws);

/// Reverses each face.
void turn_inside_out(Meshd& mesh);

/// Around the mean of the vertices, which is the origin then: as many times as large as there are vertices.
Meshd around_the_mean(Meshd mesh);

/// The same faces in another order, from other corners on.
Meshd relisted(Meshd mesh, DrawStream& draws);

/// The vertices and faces of both; those of `other` come after the mesh's.
Meshd together(Meshd mesh, const Meshd& other);

/// One more vertex in the middle of an edge, or of a face: flat there.
Meshd with_flat_vertex(const Meshd& mesh, DrawStream& draws);

/// A vertex, the middle of an edge or of a face, a point of an edge's line beyond it, or of a face's plane outside it.
Point3d on_a_face_plane(const Meshd& mesh, DrawStream& draws);

/// The middle of two vertices; inside, or on a face.
Point3d between_vertices(const Meshd& mesh, DrawStream& draws);

inline Meshd shifted(Meshd mesh, const Vector3d& by) {
  for (Point3d& p : mesh.vertices) p = p + by;
  return mesh;
}

/// By one integer map of determinant not 0, entries at most 4; they stay where a singular one is drawn.
template <class... Shapes>
void map_linearly(DrawStream& draws, Shapes&... shapes) {
  const auto row = [&draws] {
    return Vector3d{small_integer(draws, 4), small_integer(draws, 4), small_integer(draws, 4)};
  };
  const Vector3d u = row(), v = row(), w = row();
  if (dot(u, cross(v, w)) == 0) return;
  const auto map = [&](auto& p) {
    const auto image = [&p](const Vector3d& r) { return r.x * p.x + r.y * p.y + r.z * p.z; };
    p = {image(u), image(v), image(w)};
  };
  (change_each(shapes, map), ...);
}

/// Mostly a mesh that breaks a rule: a face missing, doubled, reversed or of two vertices, all in one plane, two
/// solids.
Meshd broken(Meshd mesh, DrawStream& draws);

Meshd tetrahedron_over(const std::array<Point3d, 4>& corners);

/// The corners are drawn by point(draws).
template <class Draw>
Meshd tetrahedron_of(DrawStream& draws, const Draw& point) {
  return tetrahedron_over({point(draws), point(draws), point(draws), point(draws)});
}

/// The faces of a tetrahedron over the first four vertices, the others taken away; fewer stay as they are.
void make_tetrahedron(Meshd& mesh);

template <auto drawn_mesh, auto drawn_point>
std::tuple<Meshd, Point3d> mesh_and_point(DrawStream& c) {
  const Meshd mesh = drawn_mesh(c);
  return {mesh, drawn_point(mesh, c)};
}

}  // namespace touchstone::catalogue
