// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/planes/point_plane.h"

namespace touchstone::robust::stages {

/// The distance has no filter: a number has to be found.
struct point_plane {
  static Perhaps<PointPlane<double>> enclosed(const Plane3d& plane, const Point3d& point);
  static Perhaps<PointPlane<double>> lattice(const Plane3d& plane, const Point3d& point);
  static PointPlane<double> exact(const Plane3d& plane, const Point3d& point);

  struct decision : detail::point_plane_side {
    static Perhaps<PlaneSide> lattice(const Plane3d& plane, const Point3d& point);
    static PlaneSide exact(const Plane3d& plane, const Point3d& point);
  };
};

}  // namespace touchstone::robust::stages
