// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/shape/shape.h"

/// Faces of meshes in JSON: triangles, or polygons of three or more corners with their triangulation.
namespace touchstone::catalogue {

/// The path of an element of the array at that path.
inline std::string element(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

/// Appends the enumerators of `faces` and `polygons` (geometry/polyhedra.h) of the mesh in the document at that path,
/// over vertices that have been read, three numbers each. If a face has more than three corners, all are polygons.
/// Their triangulation is read if the document has one, and validated with the mesh; otherwise it is computed. Throws
/// InvalidInput naming the path and the rule. Double or mpq_class.
template <class Real>
void read_faces(const Json& mesh, const std::string& path, const Real* vertices, std::size_t count,
                std::vector<Word>& words);

/// The members of a mesh with polygons: the polygons are its faces, and the triangles their triangulation.
Json with_polygons_as_faces(Json mesh);

}  // namespace touchstone::catalogue
