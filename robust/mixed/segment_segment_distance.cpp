// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_segment_distance.h"

#include "robust/kernel/nearest_points.h"
#include "robust/kernel/valid_capsules.h"

namespace touchstone::robust {
namespace {

template <class Segment>
ClosestPair3<double> closest_in_space(const Segment& a, const Segment& b) {
  if (!kernel::valid(a) || !kernel::valid(b))
    validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const auto [at, exponent] = kernel::whole_points(a.a, a.b, b.a, b.b);
  return kernel::closest_pair(kernel::nearest_pair({at[0], at[1]}, {at[2], at[3]}), exponent);
}

}  // namespace

ClosestPair2<double> segment_segment_distance(const Segment2d& a, const Segment2d& b) {
  return kernel::in_plane(closest_in_space(a, b));
}
ClosestPair3<double> segment_segment_distance(const Segment3d& a, const Segment3d& b) { return closest_in_space(a, b); }

}  // namespace touchstone::robust
