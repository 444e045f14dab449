// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/meshes/diagnosis.h"
#include "report/uses.h"

namespace touchstone::report {

/// A page that stands alone: what a mesh is and what is wrong with it, in words, and a figure that turns (viewer.js),
/// of the mesh and of the first places of each defect. A large mesh is drawn coarser (coarse_mesh.h). Same mesh, same
/// bytes.
std::string mesh_page(const MeshFile& file, const Diagnosis& diagnosis);

}  // namespace touchstone::report
