// SPDX-License-Identifier: Apache-2.0
#include "robust/response/elastic_collision.h"

#include "robust/kernel/contacts/impulse.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The stage `enclosed`, inlined where an answer is made of its numbers: constructed out of place and copied it would
/// cost more.
[[gnu::always_inline]] inline std::optional<kernel::Impelled> enclosed_velocities(const Massesd& masses,
                                                                                  const Velocitiesd& velocities,
                                                                                  const Vector3d& n) {
  using namespace kernel;
  const auto& [v, w] = velocities;
  const Two both_masses(masses.first, masses.second);
  if (!in_narrow_window(both_masses, Two(v.x, w.x), Two(v.y, w.y), Two(v.z, w.z), Two(n.x, n.y), Two(n.z, 0)) ||
      !(both_masses >= Two(0x1p-60)) || !rounds_to_nearest())
    return std::nullopt;
  return enclosed_impulse(masses, velocities, n, factor(Two(-2 * masses.second, 2 * masses.first)));
}

void validate_elastic_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal) {
  if (kernel::valid(masses) && kernel::valid(velocities) && kernel::valid(normal, rule::normal)) return;
  validation::validate_all("masses", masses, "velocities", velocities, "normal",
                           validation::under(rule::normal, normal));
}

}  // namespace

Perhaps<Velocitiesd> stages::elastic_collision::enclosed(const Massesd& masses, const Velocitiesd& velocities,
                                                         const Vector3d& n) {
  if (const auto after = enclosed_velocities(masses, velocities, n)) return after->answer();
  return std::nullopt;
}

Velocitiesd stages::elastic_collision::exact(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& n) {
  return kernel::exact_impulse(masses, velocities, n, 2, 1);
}

Decided<Velocitiesd> stages::elastic_collision::ask(const Massesd& masses, const Velocitiesd& velocities,
                                                    const Vector3d& n) {
  return in_turn<elastic_collision, Stage::enclosed, validate_elastic_collision, Stage::exact>(masses, velocities, n);
}

Velocitiesd elastic_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal) {
  if (const auto after = enclosed_velocities(masses, velocities, normal)) return after->answer();
  return answer_in_turn<stages::elastic_collision, validate_elastic_collision, Stage::exact>(masses, velocities,
                                                                                             normal);
}

}  // namespace touchstone::robust
