// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/hulls/surface.h"

namespace touchstone::robust::hulls {

/// Either the faces of a solid, or points, at most three, that span all others.
struct Solid {
  std::vector<Face> faces;
  std::vector<FramePoint> simplex;
};

/// The convex hull of finite points, at least one. Equal points are represented by the first in the list. `latest`
/// becomes the later one of its value and the last stage that any decision needed. From `worth_looking` points on, the
/// far ones are searched first, which affects only time; so do threads.
inline constexpr std::size_t usually_worth_looking = 32;
Solid solid_of(const std::vector<Point3d>& points, const Frame& frame, Stage& latest,
               std::size_t worth_looking = usually_worth_looking, std::size_t threads = 1);

/// A surface that has grown over the far points, with the other points above it kept for its facets; nullopt if the
/// surface is too thin to be certain. (directions.cpp)
std::optional<Surface> surface_of_far_points(const std::vector<Point3d>& points, const Frame& frame, Stage& latest,
                                              std::size_t threads);

inline FramePoint framed(const Frame& frame, const std::vector<Point3d>& points, std::size_t i) {
  const auto [x, y, z] = frame(points[i]);
  return {x, y, z, static_cast<std::int32_t>(i), -1};
}

/// The set of points so far, by their coordinates: of equal ones only the first is new.
class Seen {
 public:
  explicit Seen(std::size_t most);
  /// `points` holds the point of every number passed before.
  bool is_new(const FramePoint& p, std::int32_t number, const std::vector<FramePoint>& points);

 private:
  std::vector<std::int32_t> slots_;
};

}  // namespace touchstone::robust::hulls
