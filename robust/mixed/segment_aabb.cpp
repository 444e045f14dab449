// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_aabb.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_segment_aabb(const kernel::Line& line, const kernel::Box& aabb) {
  if (kernel::valid(line.from) && kernel::valid(line.to) && kernel::valid(aabb)) return;
  validation::validate_numbers("segment", line.segment()), validation::validate_numbers("aabb", aabb);
  validation::validate("aabb", aabb);
}

}  // namespace

/// The filter does not detect numbers that are not finite: lines and boxes are validated first.
Decided<Passage<double>> stages::segment_aabb::ask(const kernel::Line& segment, const kernel::Box& aabb) {
  return in_turn<segment_aabb, validate_segment_aabb, Stage::filter, Stage::enclosed, Stage::exact>(segment, aabb);
}

Perhaps<PassageRelation> stages::segment_aabb::decision::lattice(const kernel::Line& segment, const kernel::Box& aabb) {
  return kernel::box_relation_on_lattice(segment, aabb);
}

PassageRelation stages::segment_aabb::decision::exact(const kernel::Line& segment, const kernel::Box& aabb) {
  return kernel::BoxPassage::exact(segment, aabb).relation;
}

Decided<PassageRelation> stages::segment_aabb::decision::past_filter(const kernel::Line& segment,
                                                                     const kernel::Box& aabb) {
  return in_turn<decision, validate_segment_aabb, Stage::lattice, Stage::exact>(segment, aabb);
}

}  // namespace touchstone::robust
