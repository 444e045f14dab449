// SPDX-License-Identifier: Apache-2.0
#include "robust/response/inelastic_collision.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// m1 v + m2 w, a factor of either mass in both.
template <class Float>
kernel::Enclosed<Float> momentum(const kernel::Factor<Float>& m1, const Float& v, const kernel::Factor<Float>& m2,
                                 const Float& w) {
  kernel::Sum sum(kernel::product(m1, kernel::factor(v)));
  return (sum += kernel::product(m2, kernel::factor(w))).value();
}

void validate_inelastic_collision(const Massesd& masses, const Velocitiesd& velocities) {
  if (kernel::valid(masses) && kernel::valid(velocities)) return;
  validation::validate_all("masses", masses, "velocities", velocities);
}

}  // namespace

/// (m1 v + m2 w) / (m1 + m2): of degree 2 by degree 1, well within the window.
Perhaps<Vector3d> stages::inelastic_collision::enclosed(const Massesd& masses, const Velocitiesd& velocities) {
  using namespace kernel;
  const auto& [v, w] = velocities;
  const Two both_masses(masses.first, masses.second);
  if (!in_window(both_masses, Two(v.x, v.y), Two(w.x, w.y), Two(v.z, w.z)) || !(both_masses >= Two(0x1p-100)) ||
      !rounds_to_nearest())
    return std::nullopt;
  const Pair<double> sum = two_sum(masses.first, masses.second);
  const Enclosed<double> mass{sum.high, sum.low, 0};
  const auto xy =
      rounded(momentum(factor(Two(masses.first)), Two(v.x, v.y), factor(Two(masses.second)), Two(w.x, w.y)) /
              Divisor(twice(mass)));
  const auto z = rounded(momentum(factor(masses.first), v.z, factor(masses.second), w.z) / Divisor(mass));
  if (!xy || !z) return std::nullopt;
  return Vector3d{xy->first(), xy->second(), *z};
}

Vector3d stages::inelastic_collision::exact(const Massesd& masses, const Velocitiesd& velocities) {
  const auto& [v, w] = velocities;
  const auto [m1, m2] = kernel::integers_of(masses.first, masses.second).at;
  const kernel::Integers<6> moving = kernel::integers_of(v.x, v.y, v.z, w.x, w.y, w.z);
  const mpz_class mass = m1 + m2;
  const auto component = [&, &m1 = m1, &m2 = m2](std::size_t axis) {
    return kernel::round_quotient(mpz_class(m1 * moving.at[axis] + m2 * moving.at[axis + 3]), mass, moving.exponent);
  };
  return {component(0), component(1), component(2)};
}

Decided<Vector3d> stages::inelastic_collision::ask(const Massesd& masses, const Velocitiesd& velocities) {
  return in_turn<inelastic_collision, Stage::enclosed, validate_inelastic_collision, Stage::exact>(masses, velocities);
}

Vector3d inelastic_collision(const Massesd& masses, const Velocitiesd& velocities) {
  return answer_in_turn<stages::inelastic_collision, Stage::enclosed, validate_inelastic_collision, Stage::exact>(
      masses, velocities);
}

}  // namespace touchstone::robust
