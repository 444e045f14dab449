// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/kdop_of_points.h"

namespace touchstone::robust::stages {

/// The lattice takes the points of which doubles do not show that others lie beyond them; exact takes all.
struct kdop_of_points {
  static Perhaps<std::vector<Slabd>> lattice(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals);
  static std::vector<Slabd> exact(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals);
  static Decided<std::vector<Slabd>> ask(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals);
};

}  // namespace touchstone::robust::stages
