// SPDX-License-Identifier: Apache-2.0
#include "robust/prepared/solid.h"

#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/kernel/solids/convex_mesh.h"

namespace touchstone::robust {
namespace {

Meshd closed(const std::string& field, Meshd mesh) {
  validation::validate_numbers(field, mesh), kernel::validate_closed(field, mesh);
  return mesh;
}

kernel::ConvexSurface convex(const std::string& field, const Meshd& mesh) {
  validation::validate_numbers(field, mesh);
  Stage latest = Stage::filter;
  return kernel::validate_convex_surface(field, mesh, latest);
}

}  // namespace

Solid::Solid(Meshd mesh, const std::string& field) : Solid(Validated{}, closed(field, std::move(mesh))) {}

Solid::Solid(Validated, Meshd mesh) : mesh_(std::move(mesh)), box_(kernel::SpaceBox::around(mesh_)), tree_(mesh_) {}

// A mesh that is convex is closed, but a refusal tells of the first rule of its own.
ConvexSolid::ConvexSolid(Meshd mesh, const std::string& field) : ConvexSolid(convex(field, mesh), std::move(mesh)) {}
ConvexSolid::ConvexSolid(const kernel::ConvexSurface& surface, Meshd&& mesh)
    : Solid(Validated{}, std::move(mesh)), surface_(surface) {}

}  // namespace touchstone::robust
