// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "audit/meshes/surface.h"
#include "audit/uses.h"
#include "geometry/polyhedra.h"

/// Operations of a reduction on meshes.
namespace touchstone::audit::reducing {

/// A mesh by its named faces.
struct FacesOfMesh {
  std::vector<Point3d> vertices;
  std::vector<meshes::Corners> faces;
};
FacesOfMesh faces_of(const Meshd& mesh);

/// The mesh of these faces, with polygons triangulated anew; nullopt if one is not a polygon.
std::optional<Meshd> mesh_of(FacesOfMesh mesh);

/// For each face the number of its connected part, by shared vertices, in the order of their first faces.
std::vector<std::size_t> components_of(const FacesOfMesh& mesh);

/// Keeps only some faces, and removes the vertices that only others use.
FacesOfMesh with_faces(const FacesOfMesh& mesh, const std::vector<bool>& kept);

/// Removes some vertices, which no face uses.
FacesOfMesh without_vertices(FacesOfMesh mesh, const std::vector<bool>& dropped);

/// Vertex i becomes vertex to[i], which maps to itself. A face loses corners that become equal to the one before; with
/// fewer than three it is removed, and so are two faces that become equal. Every edge that was in an even number of
/// faces still is. Merged vertices are removed, and those that no face uses any more.
FacesOfMesh merged(const FacesOfMesh& mesh, const std::vector<Index>& to);

/// The convex hull of some of the vertices; nullopt if it is flat.
std::optional<FacesOfMesh> hull_of(const std::vector<Point3d>& vertices);

/// The vertices that faces use, in the order of a space-filling curve, so that most neighbours in space are neighbours
/// in the list.
std::vector<Index> along_curve(const FacesOfMesh& mesh);

/// The neighbours of each vertex along edges of faces, ascending.
std::vector<std::vector<Index>> neighbours_of(const FacesOfMesh& mesh);

}  // namespace touchstone::audit::reducing
