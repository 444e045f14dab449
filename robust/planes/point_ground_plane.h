// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/validation.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

/// Decides whether a point lies above, on or below the ground, the plane y = 0; y is up.
///
/// `on` means y is exactly 0, or -0.0. Right for all finite doubles in every floating-point environment: sign and zero
/// are read from bits, because a comparison that reads denormals as zero puts 2^-1074 on the ground. NaN and infinities
/// throw InvalidInput, which names the field and "finite number". Contract: reference/planes/point_ground_plane.h.
inline Height point_ground_plane(const Point3d& point) {
  if (!kernel::valid(point)) validation::validate("point", point);
  if (validation::zero(point.y)) return Height::on;
  return validation::negative(point.y) ? Height::below : Height::above;
}

}  // namespace touchstone::robust
