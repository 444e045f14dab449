// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_aabb.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_ray_aabb(const kernel::Line& line, const kernel::Box& aabb) {
  if (kernel::valid(line.from) && kernel::valid(line.ray().direction, rule::direction) && kernel::valid(aabb)) return;
  validation::validate_numbers("ray", line.ray()), validation::validate_numbers("aabb", aabb);
  validation::validate("ray", line.ray()), validation::validate("aabb", aabb);
}

}  // namespace

/// The filter does not detect numbers that are not finite: lines and boxes are validated first.
Decided<Passage<double>> stages::ray_aabb::ask(const kernel::Line& ray, const kernel::Box& aabb) {
  return in_turn<ray_aabb, validate_ray_aabb, Stage::filter, Stage::enclosed, Stage::exact>(ray, aabb);
}

Perhaps<PassageRelation> stages::ray_aabb::decision::lattice(const kernel::Line& ray, const kernel::Box& aabb) {
  return kernel::box_relation_on_lattice(ray, aabb);
}

PassageRelation stages::ray_aabb::decision::exact(const kernel::Line& ray, const kernel::Box& aabb) {
  return kernel::BoxPassage::exact(ray, aabb).relation;
}

Decided<PassageRelation> stages::ray_aabb::decision::past_filter(const kernel::Line& ray, const kernel::Box& aabb) {
  return in_turn<decision, validate_ray_aabb, Stage::lattice, Stage::exact>(ray, aabb);
}

}  // namespace touchstone::robust
