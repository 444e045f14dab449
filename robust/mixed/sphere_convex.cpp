// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/sphere_convex.h"

#include "geometry/validation.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/kernel/solids/solid_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

void validate_sphere_convex(const Sphere3d& sphere, const Meshd& mesh) {
  validation::validate_numbers("sphere", sphere), validation::validate_numbers("mesh", mesh);
  validation::validate("sphere", sphere);
  Stage latest = Stage::filter;
  kernel::validate_convex("mesh", mesh, latest);
}

}  // namespace

Perhaps<Contact> stages::sphere_convex::filter(const Sphere3d& sphere, const Meshd& mesh) {
  return kernel::certain_contact(kernel::core_of(sphere), sphere.radius, mesh);
}

Contact stages::sphere_convex::exact(const Sphere3d& sphere, const Meshd& mesh) {
  return kernel::exact_contact(kernel::core_of(sphere), sphere.radius, mesh);
}

Decided<Contact> stages::sphere_convex::ask(const Sphere3d& sphere, const Meshd& mesh) {
  return in_turn<sphere_convex, validate_sphere_convex, Stage::filter, Stage::exact>(sphere, mesh);
}

Contact sphere_convex(const Sphere3d& sphere, const Meshd& mesh) {
  return stages::sphere_convex::ask(sphere, mesh).answer;
}

Contact sphere_convex(const Sphere3d& sphere, const ConvexSolid& solid) {
  validation::validate("sphere", sphere);
  return answer_in_turn<stages::sphere_convex, Stage::filter, Stage::exact>(sphere, solid.mesh());
}

}  // namespace touchstone::robust
