// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/penalty_force.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. Of degree 4 and more, they fit no lattice.
struct penalty_force {
  static Perhaps<Vector3d> enclosed(const Point3d& p, const Vector3d& v, const Plane3d& plane, double stiffness,
                                    double damping);
  static Vector3d exact(const Point3d& p, const Vector3d& v, const Plane3d& plane, double stiffness, double damping);
  static Decided<Vector3d> ask(const Point3d& p, const Vector3d& v, const Plane3d& plane, double stiffness,
                               double damping);
};

}  // namespace touchstone::robust::stages
