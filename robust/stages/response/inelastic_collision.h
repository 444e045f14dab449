// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/inelastic_collision.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found.
struct inelastic_collision {
  static Perhaps<Vector3d> enclosed(const Massesd& masses, const Velocitiesd& velocities);
  static Vector3d exact(const Massesd& masses, const Velocitiesd& velocities);
  static Decided<Vector3d> ask(const Massesd& masses, const Velocitiesd& velocities);
};

}  // namespace touchstone::robust::stages
