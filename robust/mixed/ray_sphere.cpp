// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/ray_sphere.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_ray_sphere(const kernel::Line& line, const kernel::Ball& sphere) {
  if (kernel::valid(line.from) && kernel::valid(line.ray().direction, rule::direction) && kernel::valid(sphere)) return;
  validation::validate_numbers("ray", line.ray()), validation::validate_numbers("sphere", sphere);
  validation::validate("ray", line.ray()), validation::validate("sphere", sphere);
}

}  // namespace

Decided<Passage<double>> stages::ray_sphere::ask(const kernel::Line& ray, const kernel::Ball& sphere) {
  return in_turn<ray_sphere, Stage::filter, Stage::enclosed, validate_ray_sphere, Stage::exact>(ray, sphere);
}

PassageRelation stages::ray_sphere::decision::exact(const kernel::Line& ray, const kernel::Ball& sphere) {
  return kernel::BallPassage::exact(ray, sphere).relation;
}

Decided<PassageRelation> stages::ray_sphere::decision::past_filter(const kernel::Line& ray,
                                                                   const kernel::Ball& sphere) {
  return in_turn<decision, validate_ray_sphere, Stage::exact>(ray, sphere);
}

}  // namespace touchstone::robust
