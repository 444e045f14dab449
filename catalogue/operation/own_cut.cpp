// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/own_cut.h"

#include <optional>
#include <utility>

#include "geometry/invalid_input.h"
#include "geometry/validation.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::catalogue {

namespace {

/// nullopt if robust refuses to make one.
std::optional<Meshd> cut_by_robust(const Meshd& mesh) {
  try {
    return robust::polygon_mesh(mesh.vertices, mesh.polygons);
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

bool is_valid(const Meshd& mesh) {
  try {
    validation::validate("mesh", mesh), robust::kernel::validate_polygons("mesh", mesh);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace

OwnCut<Meshd>::OwnCut(const Meshd& mesh) : mesh_(mesh) {
  if (mesh.polygons.empty()) return;
  std::optional<Meshd> own = cut_by_robust(mesh);
  if ((own && own->faces == mesh.faces) || !is_valid(mesh)) return;
  cut_ = own ? std::move(*own) : robust::polygon_mesh(mesh.vertices, mesh.polygons);  // throws
}

}  // namespace touchstone::catalogue
