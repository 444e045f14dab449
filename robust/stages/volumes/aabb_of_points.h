// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "robust/kernel/staged.h"
#include "robust/volumes/aabb_of_points.h"

namespace touchstone::robust::stages {

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

}  // namespace touchstone::robust::stages
