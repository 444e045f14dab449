// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"

namespace touchstone::audit {

struct Repaired {
  MeshFile mesh;                     ///< without lines and notes; numbers count from 0
  std::vector<std::string> changes;  ///< one clause each, in the numbers of the file that was repaired
  Diagnosis left;                    ///< of the mesh, as any other file
};

/// What is certain of a repair, and nothing else: vertices in equal positions become one (or those that `how` merges);
/// of a corner that a face names twice in a row one is left, and faces with fewer than three corners left are dropped;
/// so are faces that repeat an earlier one in the same order; faces that are not planar become triangles where `how`
/// says so; faces are reversed as Diagnosis::reversed of what is then left says. Faces keep their order and, but for
/// that, their corners. Vertices that no face names stay. `diagnosis` is that of the file, prepared in the same way.
///
/// A part that is closed keeps vertices of its own, unless `how` merges or merging them with those of other parts makes
/// a solid.
Repaired repaired(const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis, const TellStep& tell = {});

/// What the file says of its surface that no repair keeps: "texture coordinates, normals"; empty where there is
/// nothing.
std::string not_kept(const MeshFile& file);

/// The mesh as a file, its format told by the ending of the name (.obj, .off, .ply, .stl). Every number reads back as
/// the same double. STL is binary, without normals: polygons are cut, and vertices in equal positions read back as one.
/// Throws InvalidInput for another ending, and for a mesh that STL cannot hold: with a coordinate that is no binary32,
/// or a polygon that cannot be cut.
std::string text_of_mesh(const MeshFile& mesh, const std::string& name);

}  // namespace touchstone::audit
