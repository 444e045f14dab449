// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/prepared.h"
#include "catalogue/codec/json.h"
#include "geometry/invalid_input.h"

/// What is said of a mesh that was read from a file, with the places of the file.
namespace touchstone::audit {

/// A refusal of that field as one of the file: `mesh.faces[4]` becomes "notch.obj:12: face 5 (mesh.faces[4])", and the
/// vertices and edges of its rule are those of the file. Empty where it speaks of another field.
std::optional<InvalidInput> in_file(const MeshFile& file, const PreparedMesh& mesh, const std::string& field,
                                    const InvalidInput& refused);

/// The places of the file that a truth names: of its members whose names end with _edge, _vertex, _face or _faces, in
/// words. An empty object where it has none.
Json places_in_file(const MeshFile& file, const PreparedMesh& mesh, const Json& truth);

/// Whether merging vertices would close a mesh that is open, a sentence each: those in equal positions, and those that
/// merging_that_closes names. `how` is the preparation of the open mesh.
std::vector<std::string> hints_of_merging(const MeshFile& file, const Preparation& how);

}  // namespace touchstone::audit
