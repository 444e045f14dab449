// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/codec/json.h"

/// The list of vectors: manifest.json next to them, with a count and a hash of every file.
namespace touchstone::audit {

inline constexpr const char* manifest_name = "manifest.json";

/// The manifest of a folder in its present state: the files *.jsonl, with the counts of lines and of refused ones, the
/// schemas and the meshes.
Json manifest_of(const std::string& folder, std::uint64_t seed);

/// The differences between the folder's files and its manifest: "orientation.jsonl: sha256: ...", one for each file.
/// Empty if it has no manifest.
std::vector<std::string> manifest_complaints(const std::string& folder);

}  // namespace touchstone::audit
