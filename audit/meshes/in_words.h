// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"
#include "catalogue/codec/json.h"

namespace touchstone::audit {

/// What a mesh is, a line each: its size, how its faces are connected, which part lies in which, notes.
std::vector<std::string> description_of(const MeshFile& file, const Diagnosis& diagnosis);

/// "It bounds a solid." or "It bounds no solid; the worst first:"
std::string verdict_of(const Diagnosis& diagnosis);

/// "4 open edges, in 1 rim; 1 face is there twice", without places; "it bounds a solid" where there is nothing.
std::string defects_in_short(const Diagnosis& diagnosis);

/// All of it; places of faces and vertices are those of the file's lists, from 0, with the lines on which they stand.
Json json_of(const MeshFile& file, const Diagnosis& diagnosis);

}  // namespace touchstone::audit
