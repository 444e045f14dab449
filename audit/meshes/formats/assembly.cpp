// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/assembly.h"

#include <algorithm>

#include "audit/counted.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {
namespace {

constexpr std::size_t most_in_small_files = std::size_t{1} << 22;

}  // namespace

Assembly::Assembly(const std::string& name, const std::string& format, std::size_t bytes)
    : most_(std::max(bytes, most_in_small_files)) {
  mesh.name = name, mesh.format = format, mesh.has_vertex_numbers = false;
}

void Assembly::require_room(std::size_t more) {
  if (more > most_ - used_)
    throw InvalidInput(mesh.name, "at most " + grouped(most_) + " vertices and corners where all parts are placed");
  used_ += more;
}

std::size_t Assembly::add_vertices(const std::vector<Point3d>& positions, const ExactTransform& transform,
                                   const std::string& placed_by) {
  const std::size_t first = mesh.vertices.size();
  for (const Point3d& position : positions) {
    const auto moved = transform == ExactTransform() ? position : image(transform, position);
    if (!moved) throw InvalidInput(mesh.name + ": " + placed_by, exact_transform_rule);
    mesh.vertices.push_back(*moved);
  }
  return first;
}

void Assembly::add_faces(std::vector<std::vector<Index>> faces, std::size_t first, const ExactTransform& transform) {
  const bool reversed = mirrors(transform);
  for (std::vector<Index>& face : faces) {
    for (Index& corner : face) corner += static_cast<Index>(first);
    if (reversed) std::reverse(face.begin(), face.end());
    mesh.faces.push_back(std::move(face));
  }
}

}  // namespace touchstone::audit::meshes
