// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "audit/meshes.h"

/// Places in a mesh file in words: vertices and faces, given by their places in MeshFile, as the file counts them.
namespace touchstone::audit {

std::string vertex_in_words(const MeshFile& file, std::size_t vertex);  ///< "vertex 3 (line 5)"
std::string face_in_words(const MeshFile& file, std::size_t face);      ///< "face 6 (line 12)"
std::string vertices_in_words(const MeshFile& file, std::size_t one,
                              std::size_t other);  ///< "vertices 3 and 17 (lines 5 and 19)"
std::string faces_in_words(const MeshFile& file, std::size_t one,
                           std::size_t other);  ///< "faces 1 and 3 (lines 7 and 9)"
/// "edge from vertex 1 to vertex 4 (lines 3 and 6)"
std::string edge_in_words(const MeshFile& file, std::size_t from, std::size_t to);
/// "notch.obj:17" where the face stands; of a binary file its name.
std::string place_of_face(const MeshFile& file, std::size_t face);

}  // namespace touchstone::audit
