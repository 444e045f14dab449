// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/segment_plane.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/plane_crossing.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

kernel::CrossingLine line_of(const Segment3d& segment, const Plane3d& plane) {
  const auto& [a, b] = segment;
  kernel::Scaled<mpz_class> first = kernel::exact_sum(kernel::height_over(plane, a)),
                            last = kernel::exact_sum(kernel::height_over(plane, b));
  kernel::to_one_unit(first, last);
  kernel::CrossingLine found{
      first, {last.n - first.n, first.exponent}, kernel::integers_of(a.x, a.y, a.z, b.x, b.y, b.z)};
  for (std::size_t axis = 0; axis < 3; ++axis) found.line.at[axis + 3] -= found.line.at[axis];
  return found;
}

void validate_segment_plane(const Segment3d& segment, const Plane3d& plane) {
  if (kernel::valid(segment.a) && kernel::valid(segment.b) && kernel::valid(plane)) return;
  validation::validate_all("segment", segment, "plane", plane);
}

}  // namespace

LinePlaneRelation stages::segment_plane::decision::exact(const Segment3d& segment, const Plane3d& plane) {
  return line_of(segment, plane).relation(true);
}

Decided<LinePlaneRelation> stages::segment_plane::decision::past_filter(const Segment3d& segment,
                                                                        const Plane3d& plane) {
  return in_turn<decision, validate_segment_plane, Stage::exact>(segment, plane);
}

Perhaps<LinePlane<double>> stages::segment_plane::enclosed(const Segment3d& segment, const Plane3d& plane) {
  using namespace kernel;
  const auto& [a, b] = segment;
  const Vector3d& n = plane.normal;
  const Two x(a.x, b.x), y(a.y, b.y), z(a.z, b.z);
  if (!in_window(Two(n.x, n.y), Two(n.z, plane.offset), x, y, z) || !rounds_to_nearest()) return std::nullopt;
  const Enclosed<Two> heights = enclosed_heights(factors(n), Two(plane.offset), factors(x, y, z));
  const Enclosed<double> e0 = first(heights), e1 = second(heights), descent = e0 - e1;
  const bool between = (e0.high > 0 && e1.high < 0) || (e0.high < 0 && e1.high > 0);
  if (!heights.settled() || !descent.settled() || !between) return std::nullopt;
  return enclosed_crossing(e0, descent, a, vector_between(Two(a.x, a.y), Two(b.x, b.y)), factor(difference(b.z, a.z)));
}

LinePlane<double> stages::segment_plane::exact(const Segment3d& segment, const Plane3d& plane) {
  return line_of(segment, plane).answer(true);
}

/// The filter computes no number: it saves the cost if there is none.
LinePlane<double> segment_plane(const Segment3d& segment, const Plane3d& plane) {
  const auto relation = stages::segment_plane::decision::filter(segment, plane);
  if (relation && *relation == LinePlaneRelation::none) return {LinePlaneRelation::none, std::nullopt, std::nullopt};
  return answer_in_turn<stages::segment_plane, Stage::enclosed, validate_segment_plane, Stage::exact>(segment, plane);
}

}  // namespace touchstone::robust
