// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when an axis-aligned box that moves along a straight line first has a common point with one at rest: `hit`
/// with the first t in [0, 1], counted in steps, or `never`; in the plane and in space.
///
/// a moves, b rests. Touching is a hit, grazing along a face too; boxes that meet at the start hit at t = 0; flat boxes
/// are valid, and velocities may be 0. Right for all finite doubles in every floating-point environment, and t
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does min >
/// max ("min <= max"). Contract: reference/sweeps/swept_aabb_aabb.h.
FirstContact<double> swept_aabb_aabb(const Aabb2d& a, const Aabb2d& b, const Vector2d& velocity);
FirstContact<double> swept_aabb_aabb(const Aabb3d& a, const Aabb3d& b, const Vector3d& velocity);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
struct swept_aabb_aabb {
  using Answer = FirstContact<double>;
  template <class Box, class Vector>
  static Perhaps<Answer> filter(const Box& a, const Box& b, const Vector& velocity);
  template <class Box, class Vector>
  static Perhaps<Answer> enclosed(const Box& a, const Box& b, const Vector& velocity);
  template <class Box, class Vector>
  static Perhaps<Answer> lattice(const Box& a, const Box& b, const Vector& velocity);
  template <class Box, class Vector>
  static Answer exact(const Box& a, const Box& b, const Vector& velocity);
  template <class Box, class Vector>
  static Decided<Answer> ask(const Box& a, const Box& b, const Vector& velocity);
};

}  // namespace stages

}  // namespace touchstone::robust
