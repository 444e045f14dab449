// SPDX-License-Identifier: Apache-2.0
// FCL as peer: its signed distance.
#include <touchstone/program/engine_main.h>

#include "depth.h"
#include "fcl_shapes.h"

using namespace touchstone;
using namespace touchstone::fcl_shapes;

/// `distance` with enable_signed_distance, documented as "exact negative distance, which is the negated penetration
/// depth", by libccd's GJK and a polytope that expands (EPA), with a distance_tolerance of 1e-6 by default.
struct FclDistance {
  static constexpr const char* name = "FCL " FCL_VERSION " (signed distance)";

  /// Without radii: it does not round solids. The translation leads from the nearest point of the first solid to that
  /// of the second, also where they overlap; without a depth it has no direction, and nothing is answered.
  std::optional<Penetration<double>> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b) {
    if (radius_a != 0 || radius_b != 0) return std::nullopt;
    const Placed p = convex(a), q = convex(b);
    const fcl::CollisionObjectd first(p.shape, p.at), second(q.shape, q.at);
    fcl::DistanceResultd result;
    fcl::distance(&first, &second, fcl::DistanceRequestd(/*nearest points*/ true, /*signed*/ true), result);
    if (result.min_distance == 0) return std::nullopt;
    const fcl::Vector3d way = (result.nearest_points[0] - result.nearest_points[1]) / result.min_distance;
    return depth::answer<double>(a, b, 0, 0, -result.min_distance, {way[0], way[1], way[2]});
  }
};

TOUCHSTONE_ENGINE_MAIN(FclDistance)
