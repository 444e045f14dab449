// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/rigid_body_collision.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. They fit no lattice.
struct rigid_body_collision {
  static Perhaps<Motions<double>> enclosed(const RigidBodyd& a, const RigidBodyd& b, const Point3d& p,
                                           const Vector3d& n, double e);
  static Motions<double> exact(const RigidBodyd& a, const RigidBodyd& b, const Point3d& p, const Vector3d& n, double e);
  static Decided<Motions<double>> ask(const RigidBodyd& a, const RigidBodyd& b, const Point3d& p, const Vector3d& n,
                                      double e);
};

}  // namespace touchstone::robust::stages
