// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/reflect_plane.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. Of degree 5, they fit no lattice.
struct reflect_plane {
  static Perhaps<Vector3d> enclosed(const Vector3d& v, const Vector3d& n);
  static Vector3d exact(const Vector3d& v, const Vector3d& n);
  static Decided<Vector3d> ask(const Vector3d& v, const Vector3d& n);
};

}  // namespace touchstone::robust::stages
