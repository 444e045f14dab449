// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/mesh_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <utility>

#include "audit/counted.h"
#include "audit/meshes/formats/reading.h"
#include "audit/platform.h"
#include "catalogue/codec/expected.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

/// The name on one line, whatever characters it has.
std::string printable(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return name;
}

bool ends_with(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() && meshes::lower(name.substr(name.size() - ending.size())) == ending;
}

struct Format {
  std::string_view ending;
  bool (*recognised)(std::string_view bytes);  ///< also true for formats that follow
  MeshFile (*read)(const std::string& name, std::string_view bytes, const meshes::ReadSibling& beside);
};

/// A reader that needs no other file.
template <MeshFile (*read)(const std::string&, std::string_view)>
MeshFile alone(const std::string& name, std::string_view bytes, const meshes::ReadSibling&) {
  return read(name, bytes);
}

constexpr std::array<Format, 7> formats{{{".glb", meshes::is_gltf, meshes::read_gltf},
                                         {".gltf", meshes::is_gltf, meshes::read_gltf},
                                         {".3mf", meshes::is_3mf, alone<meshes::read_3mf>},
                                         {".ply", meshes::is_ply, alone<meshes::read_ply>},
                                         {".off", meshes::is_off, alone<meshes::read_off>},
                                         {".stl", meshes::is_stl, alone<meshes::read_stl>},
                                         {".obj", meshes::is_obj, alone<meshes::read_obj>}}};

/// Devices and pipes need not end, and the length that a file system reports is no promise.
std::string content(const std::string& path) {
  std::error_code unknown;
  const auto type = std::filesystem::status(path_of(path), unknown).type();
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

MeshFile read(const std::string& name, std::string_view bytes, const meshes::ReadSibling& beside) {
  const auto named =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return ends_with(name, f.ending); });
  const auto recognised =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return f.recognised(bytes); });
  const auto format = recognised != formats.end() ? recognised : named;
  if (format == formats.end())
    throw InvalidInput(printable(name),
                       "OBJ, PLY, OFF, STL, glTF or 3MF: neither its content nor its name tells that it is one");
  MeshFile mesh = format->read(printable(name), bytes, beside);
  if (named != formats.end() && named->read != format->read)
    mesh.notes.insert(mesh.notes.begin(), "the content is " + mesh.format + ", whatever the name says");
  return mesh;
}

}  // namespace

bool named_as_mesh(const std::string& path) {
  return std::any_of(formats.begin(), formats.end(), [&](const Format& f) { return ends_with(path, f.ending); });
}

MeshFile read_mesh_file(const std::string& path) {
  return read(path, content(path),
              [&](const std::string& name) { return content((path_of(path).parent_path() / path_of(name)).string()); });
}

MeshFile parse_mesh_file(const std::string& name, std::string_view bytes) {
  return read(name, bytes, [&](const std::string& beside) -> std::string {
    throw InvalidInput(printable(name), "all in one file: " + printable(beside) + " is not at hand");
  });
}

std::vector<std::string> reading_of(const MeshFile& mesh) {
  std::map<std::size_t, std::size_t> faces_with;
  std::vector<bool> named(mesh.vertices.size());
  for (const std::vector<Index>& face : mesh.faces) {
    ++faces_with[face.size()];
    for (const Index corner : face) named[corner] = true;
  }
  std::string counts = mesh.format + ": " + meshes::vertices(mesh.vertices.size());
  for (const auto& [corners, count] : faces_with)
    counts += ", " + counted(count, "face") + " of " + std::to_string(corners) + " corners";
  std::vector<std::string> lines{counts};
  if (const auto unnamed = std::count(named.begin(), named.end(), false); unnamed > 0)
    lines.push_back(meshes::vertices(static_cast<std::size_t>(unnamed)) + " in no face");
  lines.insert(lines.end(), mesh.notes.begin(), mesh.notes.end());
  std::string over;
  for (const auto& [keyword, count] : mesh.passed_over)
    over += (over.empty() ? "passed over: " : ", ") + grouped(count) + " " + keyword;
  if (!over.empty()) lines.push_back(over);
  return lines;
}

}  // namespace touchstone::audit
