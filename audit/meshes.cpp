// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <utility>

#include "audit/meshes/reading.h"
#include "catalogue/codec/expected.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

/// On one line, whatever the file is called.
std::string printable(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return name;
}

bool ends_with(std::string_view name, std::string_view ending) {
  if (name.size() < ending.size()) return false;
  const std::string_view end = name.substr(name.size() - ending.size());
  for (std::size_t i = 0; i < end.size(); ++i) {
    const char c = end[i] >= 'A' && end[i] <= 'Z' ? static_cast<char>(end[i] - 'A' + 'a') : end[i];
    if (c != ending[i]) return false;
  }
  return true;
}

using Reader = Meshd (*)(const std::string&, std::string_view);

Reader reader_of(const std::string& name) {
  constexpr std::array<std::pair<const char*, Reader>, 4> readers{
      {{".obj", meshes::read_obj}, {".ply", meshes::read_ply}, {".off", meshes::read_off}, {".stl", meshes::read_stl}}};
  for (const auto& [ending, reader] : readers) {
    if (ends_with(name, ending)) return reader;
  }
  throw InvalidInput(printable(name), "a name that ends with .obj, .ply, .off or .stl");
}

std::string content(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const int error = errno;
  try {
    if (file) return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  } catch (const std::ios_base::failure&) {  // a folder, for one
    throw InvalidInput(printable(path), "cannot be read: it is no file");
  }
  throw InvalidInput(printable(path), "cannot be read: " + why_of(error));
}

}  // namespace

Meshd read_mesh(const std::string& path) {
  const Reader reader = reader_of(path);
  return reader(printable(path), content(path));
}

Meshd parse_mesh(const std::string& name, std::string_view bytes) { return reader_of(name)(printable(name), bytes); }

}  // namespace touchstone::audit
