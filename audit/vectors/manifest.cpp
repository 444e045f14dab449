// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/manifest.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "audit/platform.h"
#include "audit/vectors/schemas.h"
#include "audit/vectors/sha256.h"
#include "audit/version.h"

namespace touchstone::audit {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::uint64_t occurrences(const std::string& text, const std::string& part) {
  std::uint64_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

Json entry_of(const fs::path& path) {
  const std::string text = text_of(path);
  Json entry = Json::object();
  if (path.extension() == ".jsonl") {
    entry["vectors"] = std::count(text.begin(), text.end(), '\n');
    entry["refused"] = occurrences(text, "\"refused\":{");
  }
  entry["bytes"] = text.size();
  entry["sha256"] = sha256(text);
  return entry;
}

/// The files that a manifest lists, sorted by their names relative to the folder.
std::map<std::string, fs::path> listed_files(const std::string& folder) {
  std::map<std::string, fs::path> files;
  for (const char* part : {"", "schemas", "meshes"}) {
    const fs::path place = path_of(folder) / part;
    if (!fs::is_directory(place)) continue;
    for (const auto& entry : fs::directory_iterator(place)) {
      const fs::path name = fs::path(part) / entry.path().filename();
      const auto kind = entry.path().extension();
      if (name != manifest_name && (kind == ".jsonl" || kind == ".json"))
        files.emplace(name.generic_string(), entry.path());
    }
  }
  return files;
}

}  // namespace

Json manifest_of(const std::string& folder, std::uint64_t seed) {
  Json files = Json::object();
  std::uint64_t vectors = 0;
  for (const auto& [name, path] : listed_files(folder)) {
    files[name] = entry_of(path);
    vectors += files[name].value("vectors", std::uint64_t{0});
  }
  Json manifest = Json::object();
  manifest["touchstone"] = vector_version;
  manifest["generator"] = std::string("touchstone ") + version_number;
  manifest["seed"] = seed;
  manifest["vectors"] = vectors;
  manifest["files"] = std::move(files);
  return manifest;
}

std::vector<std::string> manifest_complaints(const std::string& folder) {
  const fs::path path = path_of(folder) / manifest_name;
  if (!fs::exists(path)) return {};
  const Json manifest = Json::parse(text_of(path), nullptr, false);
  if (!manifest.is_object() || !manifest.contains("files") || !manifest["files"].is_object())
    return {std::string(manifest_name) + ": files: an object of names"};
  std::vector<std::string> complaints;
  const auto present = listed_files(folder);
  for (const auto& [name, entry] : manifest["files"].items()) {
    const auto found = present.find(name);
    if (found == present.end()) {
      complaints.push_back(name + ": missing, " + manifest_name + " lists it");
      continue;
    }
    const Json actual = entry_of(found->second);
    for (const auto& [field, value] : actual.items()) {
      const Json listed = entry.is_object() ? entry.value(field, Json()) : Json();
      if (listed == value) continue;
      complaints.push_back(name + ": " + field + " is " + one_line(value) + ", " + manifest_name + " says " +
                           one_line(listed));
      break;
    }
  }
  for (const auto& [name, file] : present) {
    if (!manifest["files"].contains(name)) complaints.push_back(name + ": not in " + manifest_name);
  }
  return complaints;
}

}  // namespace touchstone::audit
