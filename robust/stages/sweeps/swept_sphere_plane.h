// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::robust::stages {

/// The filter knows the steps that hit at the start, and those that never do: no number has to be found. There is no
/// lattice: squares of heights go beyond it.
struct swept_sphere_plane {
  using Answer = FirstContact<double>;
  static Perhaps<Answer> filter(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane);
  static Perhaps<Answer> enclosed(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane);
  static Answer exact(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane);
  static Decided<Answer> ask(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane);
};

}  // namespace touchstone::robust::stages
