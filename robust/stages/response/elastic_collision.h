// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/elastic_collision.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. Of degree 7, they fit no lattice.
struct elastic_collision {
  static Perhaps<Velocitiesd> enclosed(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n);
  static Velocitiesd exact(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n);
  static Decided<Velocitiesd> ask(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n);
};

}  // namespace touchstone::robust::stages
