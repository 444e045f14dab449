// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/named_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {
namespace {

constexpr std::string_view before = "meshes/", behind = ".json";

bool is_name(std::string_view text) {
  return !text.empty() && text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == text.npos;
}

/// True if a file lies below a folder, after following links.
bool lies_in(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code unknown;
  const auto outer = std::filesystem::canonical(folder, unknown);
  const auto inner = std::filesystem::canonical(file, unknown);
  return !unknown && std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

std::optional<std::string> text_of_named_file(const std::string& folder, const std::string& field,
                                              const std::string& text) {
  if (!is_name(field) || !text.ends_with(behind)) return std::nullopt;  // no field of ours has another name
  const bool whole = text.starts_with(before) && text.size() > before.size() + behind.size();
  expect(whole && is_name(std::string_view(text).substr(before.size(), text.size() - before.size() - behind.size())),
         field + ": a file meshes/NAME.json, NAME of small letters, digits and _");
  // A folder without a name, the current one, has no canonical path.
  const std::filesystem::path place = folder.empty() ? u8"." : std::u8string(folder.begin(), folder.end()),
                              path = place / text;
  std::error_code none;
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, none)) file.open(path, std::ios::binary);
  expect(file.is_open(), field + ": " + text + ": a file that can be read");
  expect(lies_in(place, path), field + ": " + text + ": a file in the folder of the claims, no link out of it");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace touchstone::certify
