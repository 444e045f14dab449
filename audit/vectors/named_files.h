// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/codec/json.h"

/// Meshes that vectors name (catalogue/families/meshes/named_meshes.h): each is a file of JSON next to the vectors, and
/// a line's input has the file's name in place of the mesh.
namespace touchstone::audit {

struct NamedFile {
  std::string name;  ///< "meshes/prism_64.json", relative to the vectors
  std::string text;
};
const std::vector<NamedFile>& named_files();

/// The input with meshes replaced by their names, if they have one.
Json with_names(Json input);

/// The input, as parse_line reads it, with the content of the files of that folder. Throws certify::Refusal or
/// InvalidInput with field and rule.
Json without_names(Json input, const std::string& folder);

}  // namespace touchstone::audit
