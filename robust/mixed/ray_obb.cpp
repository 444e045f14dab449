// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_obb.h"

#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_ray_obb(const kernel::Line& line, const Obb3d& obb) {
  kernel::validate_with_obb("ray", line.ray(), "obb", obb);
}

}  // namespace

Decided<Passage<double>> stages::ray_obb::ask(const kernel::Line& ray, const Obb3d& obb) {
  return in_turn<ray_obb, validate_ray_obb, Stage::enclosed, Stage::exact>(ray, obb);
}

Passage<double> ray_obb(const Ray3d& ray, const Obb3d& obb) { return stages::ray_obb::ask(ray, obb).answer; }

}  // namespace touchstone::robust
