// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::robust::stages {

/// The exact stage compares the bits as integers; there is no lattice.
struct aabb_aabb : detail::aabb_aabb {
  static Contact exact(const Aabb2d& a, const Aabb2d& b);
  static Contact exact(const Aabb3d& a, const Aabb3d& b);
};

}  // namespace touchstone::robust::stages
