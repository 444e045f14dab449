// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "audit/meshes/formats/mesh_file.h"

/// Places in a mesh file in words: vertices and faces, given by their places in MeshFile, as the file counts them. In a
/// file whose vertices have no numbers they are told by their positions. Where a file names its parts, and two or more,
/// a face is said to be of one.
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
/// "1e-10 apart, 5e-11 of the size", which is what --merge takes.
std::string apart_in_words(double apart, double size);
/// "notch.obj:17" where the face stands; of a binary file its name.
std::string place_of_face(const MeshFile& file, std::size_t face);

}  // namespace touchstone::audit
