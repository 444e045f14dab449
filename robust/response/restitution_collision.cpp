// SPDX-License-Identifier: Apache-2.0
#include "robust/response/restitution_collision.h"

#include "robust/kernel/contacts/impulse.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The stage `enclosed`, inlined where an answer is made of its numbers: constructed out of place and copied it would
/// cost more.
[[gnu::always_inline]] inline std::optional<kernel::Impelled> enclosed_velocities(const Massesd& masses,
                                                                                  const Velocitiesd& velocities,
                                                                                  const Vector3d& n, double e) {
  using namespace kernel;
  const auto& [v, w] = velocities;
  const Two both_masses(masses.first, masses.second);
  const bool near_one =
      in_narrow_window(both_masses, Two(v.x, w.x), Two(v.y, w.y), Two(v.z, w.z), Two(n.x, n.y), Two(n.z, e));
  if (!near_one || !(both_masses >= Two(0x1p-60)) || !(0 <= e && e <= 1) || !rounds_to_nearest()) return std::nullopt;
  const Pair<double> bounce = two_sum(1.0, e);
  const Factor<double> one_and_e = factor(bounce);
  const Term2<Two> c = product(both(one_and_e, one_and_e), factor(Two(-masses.second, masses.first)));
  return enclosed_impulse(masses, velocities, n, factor(Enclosed<Two>{c.head, c.tail, Two()}));
}

void validate_restitution_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal,
                                    double e) {
  if (kernel::valid(masses) && kernel::valid(velocities) && kernel::valid(normal, rule::normal) &&
      kernel::valid(e, rule::restitution))
    return;
  validation::validate_all("masses", masses, "velocities", velocities, "normal",
                           validation::under(rule::normal, normal), "e", validation::under(rule::restitution, e));
}

}  // namespace

Perhaps<Velocitiesd> stages::restitution_collision::enclosed(const Massesd& masses, const Velocitiesd& velocities,
                                                             const Vector3d& n, double e) {
  if (const auto after = enclosed_velocities(masses, velocities, n, e)) return after->answer();
  return std::nullopt;
}

Velocitiesd stages::restitution_collision::exact(const Massesd& masses, const Velocitiesd& velocities,
                                                 const Vector3d& n, double e) {
  const auto [one, part] = kernel::integers_of(1.0, e).at;
  return kernel::exact_impulse(masses, velocities, n, one + part, one);
}

Decided<Velocitiesd> stages::restitution_collision::ask(const Massesd& masses, const Velocitiesd& velocities,
                                                        const Vector3d& n, double e) {
  return in_turn<restitution_collision, Stage::enclosed, validate_restitution_collision, Stage::exact>(
      masses, velocities, n, e);
}

Velocitiesd restitution_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal,
                                  double e) {
  if (const auto after = enclosed_velocities(masses, velocities, normal, e)) return after->answer();
  return answer_in_turn<stages::restitution_collision, validate_restitution_collision, Stage::exact>(masses, velocities,
                                                                                                     normal, e);
}

}  // namespace touchstone::robust
