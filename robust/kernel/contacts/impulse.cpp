// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/impulse.h"

namespace touchstone::robust::kernel {

Velocitiesd exact_impulse(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n,
                          const mpz_class& bounce, const mpz_class& one) {
  const auto& [v, w] = velocities;
  const Integers<6> moving = integers_of(v.x, v.y, v.z, w.x, w.y, w.z);
  const Vector3<mpz_class> normal = integer_vector(integers_of(n)), first{moving.at[0], moving.at[1], moving.at[2]},
                           second{moving.at[3], moving.at[4], moving.at[5]};
  const auto [m1, m2] = integers_of(masses.first, masses.second).at;
  const mpz_class approach = bounce * dot(first - second, normal), below = one * (m1 + m2) * dot(normal, normal);
  const mpz_class to_first = -m2 * approach, to_second = m1 * approach;
  return {pushed(first, to_first, below, normal, moving.exponent),
          pushed(second, to_second, below, normal, moving.exponent)};
}

}  // namespace touchstone::robust::kernel
