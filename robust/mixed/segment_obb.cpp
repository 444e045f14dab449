// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_obb.h"

#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

void validate_segment_obb(const kernel::Line& line, const Obb3d& obb) {
  kernel::validate_with_obb("segment", line.segment(), "obb", obb);
}

}  // namespace

Decided<Passage<double>> stages::segment_obb::ask(const kernel::Line& segment, const Obb3d& obb) {
  return in_turn<segment_obb, validate_segment_obb, Stage::enclosed, Stage::exact>(segment, obb);
}

Passage<double> segment_obb(const Segment3d& segment, const Obb3d& obb) {
  return stages::segment_obb::ask(segment, obb).answer;
}

}  // namespace touchstone::robust
