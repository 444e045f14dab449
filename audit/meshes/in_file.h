// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "catalogue/codec/json.h"
#include "geometry/invalid_input.h"

/// Texts about a mesh that was read from a file, with positions in the file.
namespace touchstone::audit {

/// Turns a refusal of that field into one of the file: `mesh.faces[4]` becomes "notch.obj:12: face 5 (mesh.faces[4])",
/// and the vertices and edges of its rule are those of the file. nullopt if it concerns another field.
std::optional<InvalidInput> in_file(const MeshFile& file, const PreparedMesh& mesh, const std::string& field,
                                    const InvalidInput& refused);

/// The positions in the file that a truth names: of its members whose names end with _edge, _vertex, _face or _faces,
/// in words. An empty object if it has none.
Json places_in_file(const MeshFile& file, const PreparedMesh& mesh, const Json& truth);

/// Hints whether merging vertices would close an open mesh, one sentence each: those in equal positions, and those that
/// merging_that_closes names. `how` is the preparation of the open mesh.
std::vector<std::string> hints_of_merging(const MeshFile& file, const Preparation& how);

}  // namespace touchstone::audit
