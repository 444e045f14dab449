// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_segment_distance.h"

#include "robust/kernel/enclosed_nearest.h"
#include "robust/kernel/nearest_points.h"
#include "robust/kernel/valid_capsules.h"

namespace touchstone::robust {
namespace {

using stages_of = stages::segment_segment_distance;

template <class Segment>
void validate(const Segment& a, const Segment& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
}

}  // namespace

Perhaps<ClosestPair2<double>> stages_of::enclosed(const Segment2d& a, const Segment2d& b) {
  return kernel::in_plane(enclosed(kernel::in_space(a), kernel::in_space(b)));
}
Perhaps<ClosestPair3<double>> stages_of::enclosed(const Segment3d& a, const Segment3d& b) {
  if (!(filters::moderate(a) & filters::moderate(b))) return std::nullopt;
  return kernel::closest_pair(filters::nearest_parts(a, b));
}

ClosestPair2<double> stages_of::exact(const Segment2d& a, const Segment2d& b) {
  return kernel::in_plane(exact(kernel::in_space(a), kernel::in_space(b)));
}
ClosestPair3<double> stages_of::exact(const Segment3d& a, const Segment3d& b) {
  const auto [at, exponent] = kernel::whole_points(a.a, a.b, b.a, b.b);
  return kernel::closest_pair(kernel::nearest_pair({at[0], at[1]}, {at[2], at[3]}), exponent);
}

Decided<ClosestPair2<double>> stages_of::ask(const Segment2d& a, const Segment2d& b) {
  return in_turn<stages_of, Stage::enclosed, validate<Segment2d>, Stage::exact>(a, b);
}
Decided<ClosestPair3<double>> stages_of::ask(const Segment3d& a, const Segment3d& b) {
  return in_turn<stages_of, Stage::enclosed, validate<Segment3d>, Stage::exact>(a, b);
}

ClosestPair2<double> segment_segment_distance(const Segment2d& a, const Segment2d& b) {
  return stages_of::ask(a, b).answer;
}
ClosestPair3<double> segment_segment_distance(const Segment3d& a, const Segment3d& b) {
  return stages_of::ask(a, b).answer;
}

}  // namespace touchstone::robust
