// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/response/damped_reflection.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found. Of degree 6, they fit no lattice.
struct damped_reflection {
  static Perhaps<Vector3d> enclosed(const Vector3d& v, const Vector3d& n, double k);
  static Vector3d exact(const Vector3d& v, const Vector3d& n, double k);
  static Decided<Vector3d> ask(const Vector3d& v, const Vector3d& n, double k);
};

}  // namespace touchstone::robust::stages
