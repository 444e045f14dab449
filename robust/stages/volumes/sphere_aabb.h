// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::robust::stages {

struct sphere_aabb : detail::sphere_aabb {
  static Perhaps<Contact> lattice(const Circle2d& sphere, const Aabb2d& aabb);
  static Perhaps<Contact> lattice(const Sphere3d& sphere, const Aabb3d& aabb);
  static Contact exact(const Circle2d& sphere, const Aabb2d& aabb);
  static Contact exact(const Sphere3d& sphere, const Aabb3d& aabb);
};

}  // namespace touchstone::robust::stages
