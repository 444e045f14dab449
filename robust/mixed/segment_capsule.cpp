// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_capsule.h"

#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_segment_capsule(const kernel::Line& line, const Capsule3d& capsule) {
  if (kernel::valid(line.segment()) && kernel::valid(capsule)) return;
  validation::validate_all("segment", line.segment(), "capsule", capsule);
}

}  // namespace

Decided<Passage<double>> stages::segment_capsule::ask(const kernel::Line& segment, const Capsule3d& capsule) {
  return in_turn<segment_capsule, validate_segment_capsule, Stage::enclosed, Stage::exact>(segment, capsule);
}

Passage<double> segment_capsule(const Segment3d& segment, const Capsule3d& capsule) {
  return stages::segment_capsule::ask(segment, capsule).answer;
}

}  // namespace touchstone::robust
