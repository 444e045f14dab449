// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "audit/meshes/prepared.h"
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

/// The lists of OFF and PLY, without a header.
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

void append(std::string& bytes, std::uint32_t number, int count = 4) {
  for (int k = 0; k < count; ++k) bytes += static_cast<char>(number >> 8 * k & 0xff);
}

std::string stl(const MeshFile& mesh, const std::string& name) {
  std::vector<std::array<float, 3>> positions;
  for (const Point3d& p : mesh.vertices) {
    for (const double x : {p.x, p.y, p.z})
      if (!(std::fabs(x) <= std::numeric_limits<float>::max()) || static_cast<double>(static_cast<float>(x)) != x)
        throw InvalidInput(name, "STL holds numbers of binary32, and " + decimal(x) +
                                     " is none, a coordinate of vertex " + std::to_string(positions.size()) +
                                     " from 0; a name that ends with .obj, .off or .ply keeps all");
    positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  std::vector<Face> triangles;
  try {
    if (!mesh.faces.empty()) triangles = prepared(mesh, {}).mesh.faces;
  } catch (const InvalidInput& refused) {
    throw InvalidInput(name, "STL holds triangles, and a polygon cannot be cut: " + refused.rule() +
                                 "; or a name that ends with .obj, .off or .ply");
  }
  std::string bytes = "binary STL";
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const Face& f : triangles) {
    bytes.append(12, '\0');  // the normal is implied by the corners
    for (const Index v : {f.a, f.b, f.c})
      for (const float x : positions[v]) append(bytes, std::bit_cast<std::uint32_t>(x));
    append(bytes, 0, 2);
  }
  return bytes;
}

}  // namespace

std::string text_of_mesh(const MeshFile& mesh, const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (ending == ".obj") return obj(mesh);
  if (ending == ".off") return off(mesh);
  if (ending == ".ply") return ply(mesh);
  if (ending == ".stl") return stl(mesh, name);
  throw InvalidInput(name, "a name that ends with .obj, .off, .ply or .stl");
}

}  // namespace touchstone::audit
