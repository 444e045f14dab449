// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_segment_distance.h"

#include "robust/kernel/enclosed/enclosed_nearest.h"
#include "robust/kernel/shapes/nearest_points.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

template <class Segment>
void validate_segment_segment_distance(const Segment& a, const Segment& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
}

}  // namespace

Perhaps<ClosestPair2<double>> stages::segment_segment_distance::enclosed(const Segment2d& a, const Segment2d& b) {
  return kernel::in_plane(enclosed(kernel::in_space(a), kernel::in_space(b)));
}
Perhaps<ClosestPair3<double>> stages::segment_segment_distance::enclosed(const Segment3d& a, const Segment3d& b) {
  if (!(filters::moderate(a) & filters::moderate(b))) return std::nullopt;
  return kernel::closest_pair(filters::nearest_parts(a, b));
}

ClosestPair2<double> stages::segment_segment_distance::exact(const Segment2d& a, const Segment2d& b) {
  return kernel::in_plane(exact(kernel::in_space(a), kernel::in_space(b)));
}
ClosestPair3<double> stages::segment_segment_distance::exact(const Segment3d& a, const Segment3d& b) {
  const auto [at, exponent] = kernel::integer_points(a.a, a.b, b.a, b.b);
  return kernel::closest_pair(kernel::nearest_pair({at[0], at[1]}, {at[2], at[3]}), exponent);
}

Decided<ClosestPair2<double>> stages::segment_segment_distance::ask(const Segment2d& a, const Segment2d& b) {
  return in_turn<stages::segment_segment_distance, Stage::enclosed, validate_segment_segment_distance<Segment2d>,
                 Stage::exact>(a, b);
}
Decided<ClosestPair3<double>> stages::segment_segment_distance::ask(const Segment3d& a, const Segment3d& b) {
  return in_turn<stages::segment_segment_distance, Stage::enclosed, validate_segment_segment_distance<Segment3d>,
                 Stage::exact>(a, b);
}

ClosestPair2<double> segment_segment_distance(const Segment2d& a, const Segment2d& b) {
  return stages::segment_segment_distance::ask(a, b).answer;
}
ClosestPair3<double> segment_segment_distance(const Segment3d& a, const Segment3d& b) {
  return stages::segment_segment_distance::ask(a, b).answer;
}

}  // namespace touchstone::robust
