// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/integers/integers.h"

/// Bodies of a list, for sums over them.
namespace touchstone::robust::kernel {

/// As GMP integers: masses times 2^mass_exponent, velocities times 2^velocity_exponent.
struct IntegerBodies {
  std::vector<Body<mpz_class>> at;
  int mass_exponent, velocity_exponent;
};
IntegerBodies integer_bodies(const std::vector<Bodyd>& bodies);

/// Sums of robust/kernel/enclosed/enclosed.h hold at most this many terms.
inline constexpr std::size_t most_enclosed_bodies = std::size_t{1} << 12;

/// Two bodies, one per lane; the partner of the last body of an odd number has the mass 1 and is at rest.
struct TwoBodies {
  Two mass, x, y, z;
};
inline TwoBodies two_bodies(const std::vector<Bodyd>& bodies, std::size_t i) {
  static constexpr Bodyd none{1, {0, 0, 0}};
  const Bodyd &a = bodies[i], &b = i + 1 < bodies.size() ? bodies[i + 1] : none;
  const Vector3d &v = a.velocity, &w = b.velocity;
  return {Two(a.mass, b.mass), Two(v.x, w.x), Two(v.y, w.y), Two(v.z, w.z)};
}

/// True if both masses are positive; within the window.
inline bool positive(Two masses) { return masses >= Two(0x1p-100); }

}  // namespace touchstone::robust::kernel
