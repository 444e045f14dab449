// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_sphere.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_segment_sphere(const kernel::Line& line, const kernel::Ball& sphere) {
  if (kernel::valid(line.from) && kernel::valid(line.to) && kernel::valid(sphere)) return;
  validation::validate_numbers("segment", line.segment()), validation::validate_numbers("sphere", sphere);
  validation::validate("sphere", sphere);
}

}  // namespace

Decided<Passage<double>> stages::segment_sphere::ask(const kernel::Line& segment, const kernel::Ball& sphere) {
  return in_turn<segment_sphere, Stage::filter, Stage::enclosed, validate_segment_sphere, Stage::exact>(segment,
                                                                                                        sphere);
}

PassageRelation stages::segment_sphere::decision::exact(const kernel::Line& segment, const kernel::Ball& sphere) {
  return kernel::BallPassage::exact(segment, sphere).relation;
}

Decided<PassageRelation> stages::segment_sphere::decision::past_filter(const kernel::Line& segment,
                                                                       const kernel::Ball& sphere) {
  return in_turn<decision, validate_segment_sphere, Stage::exact>(segment, sphere);
}

}  // namespace touchstone::robust
