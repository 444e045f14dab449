// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/capsule_convex.h"

#include "geometry/validation.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/kernel/solids/solid_distance.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

void validate_capsule_convex(const Capsule3d& capsule, const Meshd& mesh) {
  validation::validate_numbers("capsule", capsule), validation::validate_numbers("mesh", mesh);
  validation::validate("capsule", capsule);
  Stage latest = Stage::filter;
  kernel::validate_convex("mesh", mesh, latest);
}

}  // namespace

Perhaps<Contact> stages::capsule_convex::filter(const Capsule3d& capsule, const Meshd& mesh) {
  return kernel::certain_contact(kernel::core_of(capsule), capsule.radius, mesh);
}

Contact stages::capsule_convex::exact(const Capsule3d& capsule, const Meshd& mesh) {
  return kernel::exact_contact(kernel::core_of(capsule), capsule.radius, mesh);
}

Decided<Contact> stages::capsule_convex::ask(const Capsule3d& capsule, const Meshd& mesh) {
  return in_turn<capsule_convex, validate_capsule_convex, Stage::filter, Stage::exact>(capsule, mesh);
}

Contact capsule_convex(const Capsule3d& capsule, const Meshd& mesh) {
  return stages::capsule_convex::ask(capsule, mesh).answer;
}

Contact capsule_convex(const Capsule3d& capsule, const ConvexSolid& solid) {
  validation::validate("capsule", capsule);
  return answer_in_turn<stages::capsule_convex, Stage::filter, Stage::exact>(capsule, solid.mesh());
}

}  // namespace touchstone::robust
