// SPDX-License-Identifier: Apache-2.0
#include "robust/response/simulation_step.h"

#include <algorithm>
#include <cstdint>

#include "geometry/validation.h"
#include "robust/kernel/contacts/contact_system.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::Dyadic;

void validate_simulation_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                              const StepSettingsd& settings) {
  validation::validate_all("bodies", bodies, "walls", walls, "settings", settings);
}

int sign(const Dyadic& a) { return sgn(a.n); }
bool at_most(const Dyadic& a, const Dyadic& b) { return sign(b - a) >= 0; }

/// The least exponent of nonzero numbers, and integers in units of 2 to that power.
class Unit {
 public:
  void add(const Dyadic& a) {
    if (sign(a) != 0) least_ = std::min(least_, a.exponent);
  }
  void add(const Vector3<Dyadic>& v) { add(v.x), add(v.y), add(v.z); }
  int exponent() const { return least_ == INT_MAX ? 0 : least_; }
  mpz_class integer(const Dyadic& a) const {
    if (sign(a) == 0) return 0;
    return a.n << static_cast<std::uint64_t>(a.exponent - least_);
  }
  Vector3<mpz_class> integer(const Vector3<Dyadic>& v) const { return {integer(v.x), integer(v.y), integer(v.z)}; }

 private:
  int least_ = INT_MAX;
};

/// A velocity: above / below, below positive.
struct Velocity {
  Vector3<Dyadic> above;
  Dyadic below{1, 0};
};

class SimulationStep {
 public:
  SimulationStep(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, const StepSettingsd& settings)
      : bodies_(bodies),
        walls_(walls),
        settings_(settings),
        timestep_(kernel::dyadic(settings.timestep)),
        fall_(timestep_ * kernel::dyadic(settings.gravity)) {
    for (const auto& [w, v, sphere] : bodies) {
      centers_.push_back(kernel::dyadic(sphere.center));
      velocities_.push_back({kernel::dyadic(v)});
    }
  }

  NextStated made() {
    if (falls_first()) fall();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      end_.push_back(movable(i) ? centers_[i] + timestep_ * mean(i, velocities_[i]) : centers_[i]);
    if (!falls_first() && !turns_first()) fall();
    find_contacts();
    respond();
    NextStated next{places_, {}};
    for (std::size_t i = 0; i < bodies_.size(); ++i) next.bodies.push_back({position(i), {}});
    if (!falls_first() && turns_first()) fall();
    for (std::size_t i = 0; i < bodies_.size(); ++i) next.bodies[i].velocity = rounded(velocities_[i]);
    return next;
  }

 private:
  bool falls_first() const { return settings_.motion == StepMotion::accelerate_then_move; }
  bool turns_first() const { return settings_.turn == StepTurn::before_move; }
  bool movable(std::size_t body) const { return !validation::zero(bodies_[body].inverse_mass); }

  void fall() {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (movable(i)) velocities_[i].above = velocities_[i].above + velocities_[i].below * fall_;
  }
  /// The mean velocity of a body during the step, times the denominator of its velocity.
  Vector3<Dyadic> mean(std::size_t body, const Velocity& v) const {
    const Dyadic half{1, -1};
    const bool curved = movable(body) && settings_.motion == StepMotion::parabola;
    return curved ? v.above + (half * v.below) * fall_ : v.above;
  }

  void find_contacts() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Dyadic radius = kernel::dyadic(bodies_[i].sphere.radius);
      for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
        if (!movable(i) && !movable(j)) continue;
        const Vector3<Dyadic> normal = end_[i] - end_[j];
        const Dyadic reach = radius + kernel::dyadic(bodies_[j].sphere.radius), square = dot(normal, normal);
        if (sign(square) == 0 || !at_most(square, reach * reach)) continue;
        take_unless_parting(i, j, normal, velocities_[i].above - velocities_[j].above);
      }
      if (!movable(i)) continue;
      for (std::size_t k = 0; k < walls_.size(); ++k) {
        const Vector3<Dyadic> normal = kernel::dyadic(walls_[k].normal);
        const auto& [x, y, z] = end_[i];
        const Dyadic height = dot(normal, Vector3<Dyadic>{x, y, z}) + kernel::dyadic(walls_[k].offset);
        if (sign(height) > 0 && !at_most(height * height, radius * radius * dot(normal, normal))) continue;
        take_unless_parting(i, bodies_.size() + k, normal, velocities_[i].above);
      }
    }
  }
  void take_unless_parting(std::size_t i, std::size_t j, const Vector3<Dyadic>& normal,
                           const Vector3<Dyadic>& relative) {
    const Dyadic parting = dot(normal, relative);
    if (sign(parting) > 0) return;
    places_.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    normals_.push_back(normal), approaching_.push_back(sign(parting) < 0);
  }

  /// All walls are one immovable body, the last.
  kernel::ContactSystem system() const {
    kernel::ContactSystem result;
    Unit inverse_mass, speed;
    for (const StepBodyd& body : bodies_) inverse_mass.add(kernel::dyadic(body.inverse_mass));
    for (const Velocity& v : velocities_) speed.add(v.above);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      result.inverse_masses.push_back(inverse_mass.integer(kernel::dyadic(bodies_[i].inverse_mass)));
      result.velocities.push_back(speed.integer(velocities_[i].above));
    }
    result.inverse_masses.emplace_back(0), result.velocities.push_back({0, 0, 0});
    result.velocity_exponent = speed.exponent();
    const auto [one, restitution] = kernel::integers_of(1.0, settings_.restitution).at;
    result.one = one;
    const mpz_class bounce = one + restitution;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      Unit length;
      length.add(normals_[k]);
      const auto& [i, j] = places_[k];
      const Index other = std::min(j, static_cast<Index>(bodies_.size()));
      Vector3<mpz_class> normal = length.integer(normals_[k]);
      mpz_class wanted = dot(normal, result.velocities[other] - result.velocities[i]) * bounce;
      result.contacts.push_back({i, other, std::move(normal), std::move(wanted)});
    }
    return result;
  }

  void respond() {
    if (std::find(approaching_.begin(), approaching_.end(), true) == approaching_.end()) return;
    const kernel::ContactSystem contacts = system();
    for (const kernel::Contacts& part : kernel::connected_parts(contacts)) {
      kernel::Contacts guess;
      std::copy_if(part.begin(), part.end(), std::back_inserter(guess),
                   [this](std::size_t contact) { return approaching_[contact]; });
      if (guess.empty()) continue;
      push(contacts, kernel::impulses_of(contacts, part, guess));  // possible: the contract's -e v
    }
  }
  void push(const kernel::ContactSystem& system, const kernel::Impulses& found) {
    std::map<Index, Vector3<mpz_class>> pushes;
    for (std::size_t k = 0; k < found.contacts.size(); ++k) {
      const kernel::IntegerContact& c = system.contacts[found.contacts[k]];
      const Vector3<mpz_class> along = found.numerators[k] * c.normal;
      pushes[c.a] = pushes[c.a] + along;
      pushes[c.b] = pushes[c.b] - along;
    }
    const mpz_class below = found.denominator * system.one;
    for (const auto& [body, push] : pushes) {
      if (sgn(system.inverse_masses[body]) == 0) continue;
      const Vector3<mpz_class> above = below * system.velocities[body] + system.inverse_masses[body] * push;
      const auto dyadic = [&system](const mpz_class& n) { return Dyadic{n, system.velocity_exponent}; };
      velocities_[body] = {{dyadic(above.x), dyadic(above.y), dyadic(above.z)}, {below, 0}};
    }
  }

  static double quotient(const Dyadic& above, const Dyadic& below) {
    return kernel::round_quotient(above.n, below.n, static_cast<std::int64_t>(above.exponent) - below.exponent);
  }
  static Vector3d rounded(const Velocity& v) {
    return {quotient(v.above.x, v.below), quotient(v.above.y, v.below), quotient(v.above.z, v.below)};
  }
  Point3d position(std::size_t body) const {
    const auto& [x, y, z] = end_[body];
    const auto nearest = [](const Dyadic& a) { return kernel::round_scaled(a.n, a.exponent); };
    if (!turns_first() || !movable(body)) return {nearest(x), nearest(y), nearest(z)};
    const Velocity& v = velocities_[body];
    const Vector3<Dyadic> displacement = timestep_ * mean(body, v);
    const auto moved = [&v](const Dyadic& from, const Dyadic& by) { return quotient(v.below * from + by, v.below); };
    const Point3<Dyadic>& from = centers_[body];
    return {moved(from.x, displacement.x), moved(from.y, displacement.y), moved(from.z, displacement.z)};
  }

  const std::vector<StepBodyd>& bodies_;
  const std::vector<Plane3d>& walls_;
  const StepSettingsd& settings_;
  Dyadic timestep_;
  Vector3<Dyadic> fall_;  ///< the change of velocity by gravity in a step
  std::vector<Point3<Dyadic>> centers_, end_;
  std::vector<Velocity> velocities_;
  std::vector<IndexPair> places_;
  std::vector<Vector3<Dyadic>> normals_;
  std::vector<bool> approaching_;
};

}  // namespace

NextStated simulation_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                           const StepSettingsd& settings) {
  validate_simulation_step(bodies, walls, settings);
  return SimulationStep(bodies, walls, settings).made();
}

}  // namespace touchstone::robust
