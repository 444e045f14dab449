// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/validation.h"
#include "robust/kernel/valid_space.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/planes/point_ground_plane.h. Right for all finite doubles in every floating-point environment.
/// There is one stage: a sign and a zero are read from bits, because where denormals are zero a comparison takes
/// 2^-1074 for the ground.
inline Height point_ground_plane(const Point3d& point) {
  if (!kernel::valid(point)) validation::validate("point", point);
  if (validation::zero(point.y)) return Height::on;
  return validation::negative(point.y) ? Height::below : Height::above;
}

/// The same, and which stage decided: always Stage::filter.
Height point_ground_plane(const Point3d& point, Stage& decided);

}  // namespace touchstone::robust
