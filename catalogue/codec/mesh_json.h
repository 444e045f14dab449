// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/shape/shape.h"

/// Faces of meshes in JSON: triangles, or polygons of three or more corners with their cut.
namespace touchstone::catalogue {

/// The path of an element of the array at that path.
inline std::string element(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

/// Appends the words of `faces` and `polygons` (geometry/polyhedra.h) of the mesh that the document at that path is,
/// over vertices that are read already, three numbers each. Where a face has more than three corners, all are polygons;
/// their cut is read where the document has one, for whoever validates the mesh to judge, and made where it has none.
/// Throws InvalidInput naming the path and the rule. Double or mpq_class.
template <class Real>
void read_faces(const Json& mesh, const std::string& path, const Real* vertices, std::size_t count,
                std::vector<Word>& words);

/// The members of a mesh that has polygons: they are its faces, and the triangles their cut.
Json with_polygons_as_faces(Json mesh);

}  // namespace touchstone::catalogue
