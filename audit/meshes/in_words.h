// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"
#include "catalogue/codec/json.h"

namespace touchstone::audit {

/// A description of a mesh, one item per line: its size, how its faces are connected, which part contains which, notes.
std::vector<std::string> description_of(const MeshFile& file, const Diagnosis& diagnosis);

/// "It bounds a solid." or "It bounds no solid; the worst first:"
std::string verdict_of(const Diagnosis& diagnosis);

/// "4 open edges, in 1 rim; 1 face is there twice", without positions; "it bounds a solid" if there are no defects.
std::string defects_in_short(const Diagnosis& diagnosis);

/// The full diagnosis; faces and vertices are indices in the file's lists, from 0, with their lines.
Json json_of(const MeshFile& file, const Diagnosis& diagnosis);

}  // namespace touchstone::audit
