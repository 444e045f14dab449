// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/restitution_collision.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. Of degree 8, they fit no lattice.
struct restitution_collision {
  static Perhaps<Velocitiesd> enclosed(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n,
                                       double e);
  static Velocitiesd exact(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n, double e);
  static Decided<Velocitiesd> ask(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n, double e);
};

}  // namespace touchstone::robust::stages
