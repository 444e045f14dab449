// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <utility>

#include "audit/meshes/reading.h"
#include "catalogue/codec/expected.h"
#include "geometry/invalid_input.h"
#include "robust/structures/polygon_mesh.h"

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

using Reader = MeshFile (*)(const std::string&, std::string_view);

Reader reader_of(const std::string& name) {
  constexpr std::array<std::pair<const char*, Reader>, 4> readers{
      {{".obj", meshes::read_obj}, {".ply", meshes::read_ply}, {".off", meshes::read_off}, {".stl", meshes::read_stl}}};
  for (const auto& [ending, reader] : readers) {
    if (ends_with(name, ending)) return reader;
  }
  throw InvalidInput(printable(name), "a name that ends with .obj, .ply, .off or .stl");
}

/// Devices and pipes need not end; nor is the length that a file system tells of a file a promise.
std::string content(const std::string& path) {
  std::error_code unknown;
  const auto type = std::filesystem::status(path, unknown).type();
  if (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::not_found)
    throw InvalidInput(printable(path), "cannot be read: it is no file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InvalidInput(printable(path), "cannot be read: " + why_of(errno));
  std::string bytes;
  std::array<char, 1 << 16> part;
  while (file.read(part.data(), part.size()) || file.gcount() > 0) {
    bytes.append(part.data(), static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > most_bytes_of_a_mesh) throw InvalidInput(printable(path), "at most 256 MiB");
  }
  return bytes;
}

Meshd cut(MeshFile file) { return robust::polygon_mesh(std::move(file.vertices), std::move(file.faces)); }

}  // namespace

MeshFile read_mesh_file(const std::string& path) {
  const Reader reader = reader_of(path);
  return reader(printable(path), content(path));
}

MeshFile parse_mesh_file(const std::string& name, std::string_view bytes) {
  return reader_of(name)(printable(name), bytes);
}

Meshd read_mesh(const std::string& path) { return cut(read_mesh_file(path)); }

Meshd parse_mesh(const std::string& name, std::string_view bytes) { return cut(parse_mesh_file(name, bytes)); }

}  // namespace touchstone::audit
