// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/sweeps/swept_aabb_aabb.h"

namespace touchstone::robust::stages {

/// The filter knows the steps that hit at the start, and those that never do: no number has to be found.
struct swept_aabb_aabb {
  using Answer = FirstContact<double>;
  static Perhaps<Answer> filter(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
  static Perhaps<Answer> filter(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);
  static Perhaps<Answer> enclosed(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
  static Perhaps<Answer> enclosed(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);
  static Perhaps<Answer> lattice(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
  static Perhaps<Answer> lattice(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);
  static Answer exact(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
  static Answer exact(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);
  static Decided<Answer> ask(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
  static Decided<Answer> ask(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);
};

}  // namespace touchstone::robust::stages
