// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/convex_hull_2d.h"

#include <algorithm>

#include "robust/hulls/planar.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

Decided<ConvexHull2> stages::convex_hull_2d::ask(const std::vector<Point2d>& points) {
  const bool valid = std::all_of(points.begin(), points.end(), [](const Point2d& p) { return kernel::valid(p); });
  if (!valid || points.empty()) validation::validate("points", points, rule::points);
  const kernel::ControlWord ieee;  // comparisons: flushed denormals would all be 0
  Stage latest = Stage::filter;
  const std::vector<Index> ring = planar_hull(points, latest);
  if (ring.size() == 1) return {{0, ring[0], {}, {}}, latest};
  if (ring.size() == 2) return {{1, {}, IndexPair{ring[0], ring[1]}, {}}, latest};
  return {{2, {}, {}, ring}, latest};
}

ConvexHull2 convex_hull_2d(const std::vector<Point2d>& points) { return stages::convex_hull_2d::ask(points).answer; }

}  // namespace touchstone::robust
