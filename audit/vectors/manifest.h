// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/codec/json.h"

/// What vectors there are: manifest.json next to them, with a count and a hash of every file.
namespace touchstone::audit {

inline constexpr const char* manifest_name = "manifest.json";

/// The manifest of a folder as it is: the files *.jsonl, with how many lines and how many of them are refused, the
/// schemas and the meshes.
Json manifest_of(const std::string& folder, std::uint64_t seed);

/// How the folder's files differ from its manifest: "orientation.jsonl: sha256: ...", one for each file. Empty where
/// it has no manifest.
std::vector<std::string> manifest_complaints(const std::string& folder);

}  // namespace touchstone::audit
