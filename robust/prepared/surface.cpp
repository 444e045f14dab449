// SPDX-License-Identifier: Apache-2.0
#include "robust/prepared/surface.h"

#include <utility>

#include "geometry/ray_mesh.h"
#include "geometry/validation.h"

namespace touchstone::robust {
namespace {

Meshd valid_faces(const std::string& field, Meshd mesh) {
  Surface::validate(field, mesh);
  return mesh;
}

}  // namespace

void Surface::validate(const std::string& field, const Meshd& mesh) {
  validation::validate_numbers(field, mesh), validation::validate(field, mesh);
  validation::validate_no_polygons(field, mesh);
}

std::optional<structures::FaceTree> Surface::tree_of(const Meshd& mesh) {
  if (mesh.faces.empty()) return std::nullopt;
  return structures::FaceTree(mesh);
}

Surface::Surface(Meshd mesh, const std::string& field)
    : mesh_(valid_faces(field, std::move(mesh))), tree_(tree_of(mesh_)) {}

}  // namespace touchstone::robust
