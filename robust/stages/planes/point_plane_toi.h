// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/planes/point_plane_toi.h"

namespace touchstone::robust::stages {

/// The filter knows the steps that stay on one side of the plane, or start behind it: no number has to be found.
struct point_plane_toi {
  using Answer = PointPlaneToi<double>;
  static Perhaps<Answer> filter(const Plane3d& plane, const Point3d& start, const Point3d& end);
  static Perhaps<Answer> enclosed(const Plane3d& plane, const Point3d& start, const Point3d& end);
  static Perhaps<Answer> lattice(const Plane3d& plane, const Point3d& start, const Point3d& end);
  static Answer exact(const Plane3d& plane, const Point3d& start, const Point3d& end);
  static Decided<Answer> ask(const Plane3d& plane, const Point3d& start, const Point3d& end);
};

}  // namespace touchstone::robust::stages
