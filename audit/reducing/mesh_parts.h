// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "audit/meshes/surface.h"
#include "audit/uses.h"
#include "geometry/polyhedra.h"

/// What a reduction makes of a mesh.
namespace touchstone::audit::reducing {

/// A mesh by its named faces.
struct FacesOfMesh {
  std::vector<Point3d> vertices;
  std::vector<meshes::Corners> faces;
};
FacesOfMesh faces_of(const Meshd& mesh);

/// The mesh of these faces, polygons cut anew; none where one is no polygon.
std::optional<Meshd> mesh_of(FacesOfMesh mesh);

/// Of each face the number of its connected part, by shared vertices, in the order of their first faces.
std::vector<std::size_t> components_of(const FacesOfMesh& mesh);

/// Only some faces, and without the vertices that only others name.
FacesOfMesh with_faces(const FacesOfMesh& mesh, const std::vector<bool>& kept);

/// Without some vertices, which no face names.
FacesOfMesh without_vertices(FacesOfMesh mesh, const std::vector<bool>& dropped);

/// Vertex i becomes vertex to[i], which stays itself. A face loses corners that become equal to the one before; with
/// fewer than three it goes, and so do two faces that become the same. Every edge that was in an even number of faces
/// still is. Vertices that are merged go, and those that no face names any more.
FacesOfMesh merged(const FacesOfMesh& mesh, const std::vector<Index>& to);

/// The convex hull of some of the vertices; none where it is flat.
std::optional<FacesOfMesh> hull_of(const std::vector<Point3d>& vertices);

/// The vertices that faces name, in the order of a curve through space on which what is near each other mostly is near
/// each other.
std::vector<Index> along_curve(const FacesOfMesh& mesh);

/// The vertices next to each vertex along edges of faces, ascending.
std::vector<std::vector<Index>> neighbours_of(const FacesOfMesh& mesh);

}  // namespace touchstone::audit::reducing
