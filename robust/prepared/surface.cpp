// SPDX-License-Identifier: Apache-2.0
#include "robust/prepared/surface.h"

#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::robust {
namespace {

Meshd valid_faces(const std::string& field, Meshd mesh) {
  Surface::validate(field, mesh);
  return mesh;
}

}  // namespace

void Surface::validate(const std::string& field, const Meshd& mesh) {
  validation::validate_numbers(field, mesh), validation::validate(field, mesh);
  kernel::validate_polygons(field, mesh);
}

std::optional<structures::FaceTree> Surface::tree_of(const Meshd& mesh) {
  if (mesh.faces.empty()) return std::nullopt;
  return structures::FaceTree(mesh);
}

std::vector<Index> Surface::named_of(const Meshd& mesh) {
  return mesh.polygons.empty() ? std::vector<Index>() : named_face_of_each(mesh);
}

Surface::Surface(Meshd mesh, const std::string& field)
    : mesh_(valid_faces(field, std::move(mesh))), named_(named_of(mesh_)), tree_(tree_of(mesh_)) {}

}  // namespace touchstone::robust
