// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "audit/meshes/repair.h"
#include "catalogue/codec/json.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {
namespace {

/// The shortest decimal that reads back; json writes small integers without a point and keeps the sign of zero.
std::string position(const Point3d& p) { return decimal(p.x) + ' ' + decimal(p.y) + ' ' + decimal(p.z); }

std::string obj(const MeshFile& mesh) {
  std::string text;
  for (const Point3d& p : mesh.vertices) text += "v " + position(p) + '\n';
  for (const auto& corners : mesh.faces) {
    text += 'f';
    for (const Index v : corners) text += ' ' + std::to_string(v + std::uint64_t{1});
    text += '\n';
  }
  return text;
}

/// As OFF and PLY have them, without a header.
std::string lists(const MeshFile& mesh) {
  std::string text;
  for (const Point3d& p : mesh.vertices) text += position(p) + '\n';
  for (const auto& corners : mesh.faces) {
    text += std::to_string(corners.size());
    for (const Index v : corners) text += ' ' + std::to_string(v);
    text += '\n';
  }
  return text;
}

std::string off(const MeshFile& mesh) {
  return fmt::format("OFF\n{} {} 0\n", mesh.vertices.size(), mesh.faces.size()) + lists(mesh);
}

std::string ply(const MeshFile& mesh) {
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
             "element face {}\nproperty list uint uint vertex_indices\nend_header\n",
             mesh.vertices.size(), mesh.faces.size()) +
         lists(mesh);
}

}  // namespace

std::string text_of_mesh(const MeshFile& mesh, const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".obj") return obj(mesh);
  if (ending == ".off") return off(mesh);
  if (ending == ".ply") return ply(mesh);
  throw InvalidInput(name, "a name that ends with .obj, .off or .ply");
}

}  // namespace touchstone::audit
