// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/own_cut.h"

#include "geometry/invalid_input.h"
#include "geometry/validation.h"
#include "robust/kernel/polygon_faces.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::catalogue {

OwnCut<Meshd>::OwnCut(const Meshd& mesh) : mesh_(mesh) {
  if (mesh.polygons.empty()) return;
  try {
    validation::validate("mesh", mesh), robust::kernel::validate_polygons("mesh", mesh);
  } catch (const InvalidInput&) {
    return;
  }
  cut_ = robust::polygon_mesh(mesh.vertices, mesh.polygons);
}

}  // namespace touchstone::catalogue
