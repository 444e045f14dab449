// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

/// The velocity of a particle after it bounced, without loss, off a wall that is perpendicular to a coordinate axis:
/// the component along that axis is negated, whether the particle approaches or recedes.
///
/// Exact for all finite doubles in every floating-point environment: the sign bit of one component is flipped, the
/// other components are returned bit for bit. NaN and infinities throw InvalidInput, which names the field and "finite
/// number". Contract: reference/response/reflect_wall.h.
inline Vector3d reflect_wall(const Vector3d& velocity, Axis axis) {
  if (!kernel::valid(velocity)) validation::validate("velocity", velocity);
  const auto turned = [axis](double component, Axis along) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(component) ^ static_cast<std::uint64_t>(axis == along)
                                                                               << 63);
  };
  return {turned(velocity.x, Axis::x), turned(velocity.y, Axis::y), turned(velocity.z, Axis::z)};
}

}  // namespace touchstone::robust
