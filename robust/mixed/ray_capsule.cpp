// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_capsule.h"

#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_ray_capsule(const kernel::Line& line, const Capsule3d& capsule) {
  if (kernel::valid(line.ray()) && kernel::valid(capsule)) return;
  validation::validate_all("ray", line.ray(), "capsule", capsule);
}

}  // namespace

Decided<Passage<double>> stages::ray_capsule::ask(const kernel::Line& ray, const Capsule3d& capsule) {
  return in_turn<ray_capsule, validate_ray_capsule, Stage::enclosed, Stage::exact>(ray, capsule);
}

Passage<double> ray_capsule(const Ray3d& ray, const Capsule3d& capsule) {
  return stages::ray_capsule::ask(ray, capsule).answer;
}

}  // namespace touchstone::robust
