// SPDX-License-Identifier: Apache-2.0
#include "robust/response/simulation_step.h"

#include <algorithm>
#include <cstdint>

#include "geometry/validation.h"
#include "robust/kernel/contacts/contact_system.h"
#include "robust/kernel/contacts/push_program.h"
#include "robust/kernel/enclosed/sure.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::Dyadic, kernel::Sure;

void validate_simulation_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                              const StepSettingsd& settings) {
  validation::validate_all("bodies", bodies, "walls", walls, "settings", settings);
}

int sign(const Dyadic& a) { return sgn(a.n); }
double nearest(const Dyadic& a) { return kernel::round_scaled(a.n, a.exponent); }
double nearest_quotient(const Dyadic& above, const Dyadic& below) {
  return kernel::round_quotient(above.n, below.n, static_cast<std::int64_t>(above.exponent) - below.exponent);
}
double nearest_quotient(const Sure& above, const Sure& below) { return nearest(above / below); }

template <class Number>
Number number(double x) {
  if constexpr (std::is_same_v<Number, Dyadic>) return kernel::dyadic(x);
  else return Number(x);
}
template <class Number, template <class> class Vector>
Vector<Number> numbers(const Vector<double>& v) {
  return {number<Number>(v.x), number<Number>(v.y), number<Number>(v.z)};
}

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

/// The step in numbers that are exact, or enclosed: then it throws kernel::Unsure where they do not decide.
template <class Number>
class SimulationStep {
 public:
  SimulationStep(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, const StepSettingsd& settings)
      : bodies_(bodies),
        walls_(walls),
        settings_(settings),
        timestep_(number<Number>(settings.timestep)),
        fall_(timestep_ * numbers<Number>(settings.gravity)) {
    centers_.reserve(bodies.size()), end_.reserve(bodies.size()), velocities_.reserve(bodies.size());
    for (const auto& [w, v, sphere] : bodies) {
      centers_.push_back(numbers<Number>(sphere.center));
      velocities_.push_back({numbers<Number>(v), one()});
    }
  }

  NextStated made() {
    if (falls_first()) fall();
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      end_.push_back(movable(i) ? centers_[i] + timestep_ * mean(i, velocities_[i]) : centers_[i]);
    if (!falls_first() && !turns_first()) fall();
    find_contacts();
    if (approach_) respond();
    NextStated next;
    next.contacts.reserve(touches_.size()), next.bodies.reserve(bodies_.size());
    for (const Touch& touch : touches_)
      next.contacts.push_back({static_cast<Index>(touch.body), static_cast<Index>(touch.other)});
    for (std::size_t i = 0; i < bodies_.size(); ++i) next.bodies.push_back({position(i), {}});
    if (!falls_first() && turns_first()) fall();
    for (std::size_t i = 0; i < bodies_.size(); ++i) next.bodies[i].velocity = rounded(velocities_[i]);
    return next;
  }

 private:
  /// A velocity: above / below, below positive; enclosed ones are over 1.
  struct Velocity {
    Vector3<Number> above;
    Number below;
  };
  struct Touch {
    std::size_t body, other;  ///< places in the answer
    Vector3<Number> normal;
    Number parting;
  };

  static Number one() { return number<Number>(1); }
  bool falls_first() const { return settings_.motion == StepMotion::accelerate_then_move; }
  bool turns_first() const { return settings_.turn == StepTurn::before_move; }
  bool movable(std::size_t body) const { return !validation::zero(bodies_[body].inverse_mass); }

  void fall() {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (movable(i)) velocities_[i].above = velocities_[i].above + velocities_[i].below * fall_;
  }
  /// The mean velocity of a body during the step, times the denominator of its velocity.
  Vector3<Number> mean(std::size_t body, const Velocity& v) const {
    const Number half = number<Number>(0.5);
    const bool curved = movable(body) && settings_.motion == StepMotion::parabola;
    return curved ? v.above + (half * v.below) * fall_ : v.above;
  }

  void find_contacts() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Number radius = number<Number>(bodies_[i].sphere.radius);
      for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
        if (!movable(i) && !movable(j)) continue;
        const Vector3<Number> normal = end_[i] - end_[j];
        const Number reach = radius + number<Number>(bodies_[j].sphere.radius), square = dot(normal, normal);
        if (sign(square) == 0 || sign(reach * reach - square) < 0) continue;
        take_unless_parting(i, j, normal, velocities_[i].above - velocities_[j].above);
      }
      if (!movable(i)) continue;
      for (std::size_t k = 0; k < walls_.size(); ++k) {
        const Vector3<Number> normal = numbers<Number>(walls_[k].normal);
        const auto& [x, y, z] = end_[i];
        const Number height = dot(normal, Vector3<Number>{x, y, z}) + number<Number>(walls_[k].offset);
        if (sign(height) > 0 && sign(radius * radius * dot(normal, normal) - height * height) < 0) continue;
        take_unless_parting(i, bodies_.size() + k, normal, velocities_[i].above);
      }
    }
  }
  void take_unless_parting(std::size_t i, std::size_t j, const Vector3<Number>& normal,
                           const Vector3<Number>& relative) {
    Number parting = dot(normal, relative);
    const int separates = sign(parting);
    if (separates > 0) return;
    touches_.push_back({i, j, normal, std::move(parting)});
    approach_ |= separates < 0;
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
    for (const Touch& touch : touches_) {
      Unit length;
      length.add(touch.normal);
      const auto i = static_cast<Index>(touch.body), other = static_cast<Index>(std::min(touch.other, bodies_.size()));
      Vector3<mpz_class> normal = length.integer(touch.normal);
      mpz_class wanted = dot(normal, result.velocities[other] - result.velocities[i]) * bounce;
      result.contacts.push_back({i, other, std::move(normal), std::move(wanted)});
    }
    return result;
  }

  void respond();
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

  static Vector3d rounded(const Velocity& v) {
    return {nearest_quotient(v.above.x, v.below), nearest_quotient(v.above.y, v.below),
            nearest_quotient(v.above.z, v.below)};
  }
  Point3d position(std::size_t body) const {
    const auto& [x, y, z] = end_[body];
    if (!turns_first() || !movable(body)) return {nearest(x), nearest(y), nearest(z)};
    const Velocity& v = velocities_[body];
    const Vector3<Number> displacement = timestep_ * mean(body, v);
    const auto moved = [&v](const Number& from, const Number& by) {
      return nearest_quotient(v.below * from + by, v.below);
    };
    const Point3<Number>& from = centers_[body];
    return {moved(from.x, displacement.x), moved(from.y, displacement.y), moved(from.z, displacement.z)};
  }

  const std::vector<StepBodyd>& bodies_;
  const std::vector<Plane3d>& walls_;
  const StepSettingsd& settings_;
  Number timestep_;
  Vector3<Number> fall_;  ///< the change of velocity by gravity in a step
  std::vector<Point3<Number>> centers_, end_;
  std::vector<Velocity> velocities_;
  std::vector<Touch> touches_;
  bool approach_ = false;
};

template <>
void SimulationStep<Dyadic>::respond() {
  const kernel::ContactSystem contacts = system();
  for (const kernel::Contacts& part : kernel::connected_parts(contacts)) {
    kernel::Contacts guess;
    std::copy_if(part.begin(), part.end(), std::back_inserter(guess),
                 [this](std::size_t contact) { return sign(touches_[contact].parting) < 0; });
    if (guess.empty()) continue;
    push(contacts, kernel::impulses_of(contacts, part, guess));  // possible: the contract's -e v
  }
}

/// All contacts together: those of parts in which nothing approaches do not push.
template <>
void SimulationStep<Sure>::respond() {
  constexpr std::size_t most_contacts = 8;  // of more the integers know sooner which of them push
  if (touches_.size() > most_contacts) throw kernel::Unsure();
  const auto push = [this](const Touch& touch, std::size_t place) {
    if (place >= bodies_.size() || (place != touch.body && place != touch.other)) return Sure();
    const double w = bodies_[place].inverse_mass;
    return Sure(place == touch.body ? w : -w);
  };
  const Sure bounce = one() + Sure(settings_.restitution);
  const std::vector<Sure> found = kernel::impulses_of(kernel::push_program(touches_, bounce, push));
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Touch& touch = touches_[k];
    for (const std::size_t place : {touch.body, touch.other}) {
      if (place >= bodies_.size() || !movable(place)) continue;
      Vector3<Sure>& v = velocities_[place].above;
      v = v + push(touch, place) * found[k] * touch.normal;
    }
  }
}

}  // namespace

Perhaps<NextStated> stages::simulation_step::enclosed(const std::vector<StepBodyd>& bodies,
                                                      const std::vector<Plane3d>& walls,
                                                      const StepSettingsd& settings) {
  const kernel::ControlWord guard;
  try {
    return SimulationStep<Sure>(bodies, walls, settings).made();
  } catch (const kernel::Unsure&) {
    return std::nullopt;
  }
}

NextStated stages::simulation_step::exact(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                                          const StepSettingsd& settings) {
  return SimulationStep<Dyadic>(bodies, walls, settings).made();
}

Decided<NextStated> stages::simulation_step::ask(const std::vector<StepBodyd>& bodies,
                                                 const std::vector<Plane3d>& walls, const StepSettingsd& settings) {
  return in_turn<simulation_step, validate_simulation_step, Stage::enclosed, Stage::exact>(bodies, walls, settings);
}

NextStated simulation_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                           const StepSettingsd& settings) {
  return stages::simulation_step::ask(bodies, walls, settings).answer;
}

}  // namespace touchstone::robust
