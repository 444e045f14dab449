// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "audit/meshes/formats/mesh_file.h"

/// Positions in a mesh file in words: vertices and faces, given by their indices in MeshFile, in the file's own
/// numbering. In a file whose vertices have no numbers they are named by their positions. If a file names two or more
/// parts, the part of a face is stated.
namespace touchstone::audit {

std::string position_in_words(const Point3d& p);                        ///< "(0.5, 0, 0)"
std::string vertex_named(const MeshFile& file, std::size_t vertex);     ///< "vertex 3", "vertex (0, 1, 0)"
std::string vertex_in_words(const MeshFile& file, std::size_t vertex);  ///< "vertex 3 (line 5)"
std::string face_in_words(const MeshFile& file, std::size_t face);      ///< "face 6 (line 12, of wing)"
std::string vertices_in_words(const MeshFile& file, std::size_t one,
                              std::size_t other);  ///< "vertices 3 and 17 (lines 5 and 19)"
std::string faces_in_words(const MeshFile& file, std::size_t one,
                           std::size_t other);  ///< "faces 1 and 3 (lines 7 and 9)"
/// "edge from vertex 1 to vertex 4 (lines 3 and 6)", "edge (0, 0, 0) - (1, 0, 0)"
std::string edge_in_words(const MeshFile& file, std::size_t from, std::size_t to);
/// "1e-10 apart, 5e-11 of the size", the unit of --merge.
std::string apart_in_words(double apart, double size);
/// "notch.obj:17" for the face's line; for a binary file its name.
std::string place_of_face(const MeshFile& file, std::size_t face);

}  // namespace touchstone::audit
