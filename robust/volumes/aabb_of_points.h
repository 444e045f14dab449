// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The least axis-aligned box that contains all of some points, in the plane or in space. For one point, or points on a
/// line or plane parallel to the axes, the box is flat there, min == max.
///
/// Exact for all finite doubles in every floating-point environment, subnormals included; 0 is returned as 0.0, never
/// as -0.0. An empty list throws InvalidInput ("points", "at least 1 point"); so do NaN and infinities, which names the
/// field and "finite number". Contract: reference/volumes/aabb_of_points.h.
Aabb2d aabb_of_points(const std::vector<Point2d>& points);
Aabb3d aabb_of_points(const std::vector<Point3d>& points);

namespace stages {

/// The filter compares doubles, the exact stage their bits as integers.
struct aabb_of_points {
  using Box = std::variant<Aabb2d, Aabb3d>;
  static Perhaps<Box> filter(const std::vector<Point2d>& points);
  static Perhaps<Box> filter(const std::vector<Point3d>& points);
  static Box exact(const std::vector<Point2d>& points);
  static Box exact(const std::vector<Point3d>& points);
  static Decided<Box> ask(const std::vector<Point2d>& points);
  static Decided<Box> ask(const std::vector<Point3d>& points);
};

}  // namespace stages

}  // namespace touchstone::robust
