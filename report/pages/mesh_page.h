// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/meshes/diagnosis.h"
#include "report/uses.h"

namespace touchstone::report {

/// A self-contained page: a description of a mesh and its defects, in words, and a rotatable figure (viewer.js) of the
/// mesh and of the first places of each defect. A large mesh is drawn coarser (coarse_mesh.h). The same mesh gives the
/// same bytes.
std::string mesh_page(const MeshFile& file, const Diagnosis& diagnosis);

}  // namespace touchstone::report
