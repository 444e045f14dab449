// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/convex_hull.h"

#include <stdexcept>

#include "geometry/validation.h"
#include "robust/hulls/planar.h"
#include "robust/hulls/solid.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/machine/parallel.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust {
namespace {

double coordinate(const Point3d& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// The coordinates onto which the span of a simplex, of one to three points, projects one to one: k and the one after
/// it.
std::size_t projected_along(const std::vector<Point3d>& simplex) {
  for (std::size_t k = 0; k < 2; ++k) {
    const auto projected = [&](std::size_t i) {
      return Point2d{coordinate(simplex[i], k), coordinate(simplex[i], (k + 1) % 3)};
    };
    if (simplex.size() == 2 && !(projected(0) == projected(1))) return k;
    if (simplex.size() == 3 && stages::orientation::ask(projected(0), projected(1), projected(2)).answer != Side::on)
      return k;
  }
  return 2;
}

}  // namespace

Decided<ConvexHull> stages::convex_hull::ask(const std::vector<Point3d>& points, std::size_t threads) {
  if (points.size() >= std::size_t{1} << 30) throw std::length_error("convex_hull: fewer than 2^30 points");
  if (threads == 0) threads = threads_of_machine();
  const kernel::ControlWord ieee;  // the bounds of robust/hulls
  const auto frame = points.empty() ? std::nullopt : hulls::frame_of(points, threads);
  if (!frame) validation::validate("points", points, rule::points);
  Stage latest = Stage::filter;
  const hulls::Solid solid = hulls::solid_of(points, *frame, latest, hulls::usually_worth_looking, threads);
  if (solid.simplex.empty()) return {{3, {}, {}, {}, solid.faces}, latest};
  std::vector<Point3d> simplex;
  for (const hulls::FramePoint& p : solid.simplex) simplex.push_back(points[static_cast<std::size_t>(p.place)]);
  const std::size_t k = projected_along(simplex);
  std::vector<Point2d> projected;
  projected.reserve(points.size());
  for (const Point3d& p : points) projected.push_back({coordinate(p, k), coordinate(p, (k + 1) % 3)});
  const std::vector<Index> ring = planar_hull(projected, latest);
  if (ring.size() == 1) return {{0, ring[0], {}, {}, {}}, latest};
  if (ring.size() == 2) return {{1, {}, IndexPair{ring[0], ring[1]}, {}, {}}, latest};
  return {{2, {}, {}, ring, {}}, latest};
}

ConvexHull convex_hull(const std::vector<Point3d>& points) { return stages::convex_hull::ask(points).answer; }
ConvexHull convex_hull(const std::vector<Point3d>& points, std::size_t threads) {
  return stages::convex_hull::ask(points, threads).answer;
}

}  // namespace touchstone::robust
