// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"

namespace touchstone::audit {

struct Repaired {
  MeshFile mesh;                     ///< without lines and notes; numbers count from 0
  std::vector<std::string> changes;  ///< one clause each, in the numbers of the file that was repaired
  Diagnosis left;                    ///< of the mesh
};

/// What is certain of a repair, and nothing else: vertices in equal positions become one (or those that `how` merges);
/// of a corner that a face names twice in a row one is left, and faces with fewer than three corners left are dropped;
/// so are faces that repeat an earlier one in the same order; faces are reversed as Diagnosis::reversed of what is then
/// left says. Faces keep their order and, but for that, their corners. Vertices that no face names stay. `diagnosis` is
/// that of the file, prepared in the same way.
Repaired repaired(const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis, const TellStep& tell = {});

/// The mesh as text, its format told by the ending of the name (.obj, .off, .ply). Every number reads back as the same
/// double. Throws InvalidInput for another ending.
std::string text_of_mesh(const MeshFile& mesh, const std::string& name);

}  // namespace touchstone::audit
