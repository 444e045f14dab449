// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"

namespace touchstone::audit {

struct Repaired {
  MeshFile mesh;                     ///< without lines and notes; numbers count from 0
  std::vector<std::string> changes;  ///< one clause each, in the numbers of the repaired file
  Diagnosis left;                    ///< of the mesh, as of any other file
};

/// Repairs only what is certain: vertices at equal positions become one (or those that `how` merges); a corner that a
/// face repeats consecutively is reduced to one, and faces with fewer than three corners left are dropped; so are faces
/// that repeat an earlier one in the same order; faces that are not planar become triangles if `how` requests it; faces
/// are reversed according to Diagnosis::reversed of the result so far. Faces keep their order and, otherwise, their
/// corners. Vertices that no face uses stay. `diagnosis` is that of the file, prepared in the same way.
///
/// A closed part keeps vertices of its own, unless `how` merges or merging them with those of other parts makes a
/// solid.
Repaired repaired(const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis, const TellStep& tell = {});

/// The attributes of the file's surface that no repair keeps: "texture coordinates, normals"; empty if there are none.
std::string not_kept(const MeshFile& file);

/// The mesh as a file, in the format given by the ending of the name (.obj, .off, .ply, .stl). Every number reads back
/// as the same double. STL is binary, without normals: polygons are triangulated, and vertices at equal positions read
/// back as one. Throws InvalidInput for another ending, and for a mesh that STL cannot represent: with a coordinate
/// that is not a binary32, or a polygon that cannot be triangulated.
std::string text_of_mesh(const MeshFile& mesh, const std::string& name);

}  // namespace touchstone::audit
