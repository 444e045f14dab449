// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/simulation_step.h"

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/around_balls.h"
#include "oracle/response/simultaneous_collisions.h"

namespace touchstone::oracle {
namespace {

using SimulationStepVelocity = Vector3<Rational>;
using SimulationStepPosition = Point3<Rational>;

template <class Number>
void validate_all_simulation_step(const std::vector<StepBody<Number>>& bodies, const std::vector<Plane<Number>>& walls,
                                  const StepSettings<Number>& settings) {
  const auto numbered = [](const char* list, std::size_t i) { return list + ("[" + std::to_string(i) + "]"); };
  for (std::size_t i = 0; i < bodies.size(); ++i) validation::validate_numbers(numbered("bodies", i), bodies[i]);
  for (std::size_t i = 0; i < walls.size(); ++i) validation::validate_numbers(numbered("walls", i), walls[i]);
  validation::validate_numbers("settings", settings);
  for (std::size_t i = 0; i < bodies.size(); ++i) validation::validate(numbered("bodies", i), bodies[i]);
  for (std::size_t i = 0; i < walls.size(); ++i) validation::validate(numbered("walls", i), walls[i]);
  validation::validate("settings", settings);
}

template <class Number>
SimulationStepVelocity exact_vector(const Vector3<Number>& v) {
  return {exact(v.x), exact(v.y), exact(v.z)};
}

/// The question in rationals, and the current state of the step.
class SimulationStepStep {
 public:
  template <class Number>
  SimulationStepStep(const std::vector<StepBody<Number>>& bodies, const std::vector<Plane<Number>>& walls,
                     const StepSettings<Number>& settings)
      : motion_(settings.motion),
        turn_(settings.turn),
        timestep_(exact(settings.timestep)),
        restitution_(exact(settings.restitution)),
        fall_(timestep_ * exact_vector(settings.gravity)) {
    for (const auto& [w, v, sphere] : bodies) {
      start_.push_back(exact(sphere.center)), radii_.push_back(exact(sphere.radius));
      movers_.push_back({exact(w), exact_vector(v)});
    }
    for (const Plane<Number>& wall : walls) walls_.push_back(exact(wall));
  }

  Truth<NextState<Rational>> made() {
    const bool falls_first = motion_ == StepMotion::accelerate_then_move;
    if (falls_first) fall();
    end_ = flown();
    if (!falls_first && turn_ == StepTurn::after_move) fall();
    find_contacts();
    const std::vector<Rational> impulses = respond();
    if (turn_ == StepTurn::before_move) end_ = flown();
    if (!falls_first && turn_ == StepTurn::before_move) fall();
    NextState<Rational> next{places_, {}};
    for (std::size_t i = 0; i < movers_.size(); ++i) next.bodies.push_back({end_[i], movers_[i].velocity});
    return {std::move(next), std::nullopt, [impulses] { return Certificate{"pushes", {{"impulses", impulses}}}; }};
  }

 private:
  bool movable(std::size_t body) const { return sgn(movers_[body].inverse_mass) != 0; }

  void fall() {
    for (std::size_t i = 0; i < movers_.size(); ++i)
      if (movable(i)) movers_[i].velocity = movers_[i].velocity + fall_;
  }

  std::vector<SimulationStepPosition> flown() const {
    const Rational half(1, 2);
    std::vector<SimulationStepPosition> at = start_;
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (!movable(i)) continue;
      const SimulationStepVelocity& v = movers_[i].velocity;
      at[i] = at[i] + timestep_ * (motion_ == StepMotion::parabola ? v + half * fall_ : v);
    }
    return at;
  }

  void find_contacts() {
    const auto ground = static_cast<Index>(movers_.size());
    std::vector<AroundBalls> around(ground);
    for (Index i = 0; i < ground; ++i) around[i].add(end_[i], radii_[i]);
    for (Index i = 0; i < ground; ++i) {
      for (Index j = i + 1; j < ground; ++j) {
        if (around[i].apart(around[j])) continue;
        const SimulationStepVelocity normal = end_[i] - end_[j];
        const Rational reach = radii_[i] + radii_[j];
        if (dot(normal, normal) <= reach * reach) take_unless_parting(i, j, j, normal);
      }
      for (Index k = 0; k < walls_.size(); ++k) {
        const Rational height = height_over(walls_[k], end_[i]);
        // The distance to the plane is height / |normal|.
        const Rational reach = radii_[i] * radii_[i] * dot(walls_[k].normal, walls_[k].normal);
        if (sgn(height) <= 0 || height * height <= reach) take_unless_parting(i, ground, ground + k, walls_[k].normal);
      }
    }
  }
  /// b: the index among bodies, with all walls being the one after the last; place: the index in the answer.
  void take_unless_parting(Index a, Index b, Index place, const SimulationStepVelocity& normal) {
    const bool wall = b == movers_.size();
    const bool one_moves = movable(a) || (!wall && movable(b));
    const bool has_length = sgn(dot(normal, normal)) != 0;
    const SimulationStepVelocity relative = wall ? movers_[a].velocity : movers_[a].velocity - movers_[b].velocity;
    if (!one_moves || !has_length || sgn(dot(normal, relative)) > 0) return;
    contacts_.push_back({a, b, normal}), places_.push_back({a, place});
  }

  /// The impulses of the contacts.
  std::vector<Rational> respond() {
    std::vector<PointBody<Rational>> with_walls = movers_;
    with_walls.push_back({0, {0, 0, 0}});
    const auto resolved = simultaneous_collisions(with_walls, contacts_, restitution_);
    const auto& after = resolved.answer.velocities.value();  // there are velocities: the contract's -e v
    for (std::size_t i = 0; i < movers_.size(); ++i) movers_[i].velocity = after[i];
    return resolved.certificate().facts.front().second;
  }

  StepMotion motion_;
  StepTurn turn_;
  Rational timestep_, restitution_;
  SimulationStepVelocity fall_;  ///< the change of velocity by gravity in a step
  std::vector<SimulationStepPosition> start_, end_;
  std::vector<Rational> radii_;
  std::vector<PointBody<Rational>> movers_;
  std::vector<Plane<Rational>> walls_;
  std::vector<BodyContact<Rational>> contacts_;
  std::vector<IndexPair> places_;
};

}  // namespace

template <Exact Number>
Truth<NextState<Rational>> simulation_step(const std::vector<StepBody<Number>>& bodies,
                                           const std::vector<Plane<Number>>& walls,
                                           const StepSettings<Number>& settings) {
  validate_all_simulation_step(bodies, walls, settings);
  return SimulationStepStep(bodies, walls, settings).made();
}
template Truth<NextState<Rational>> simulation_step(const std::vector<StepBodyd>&, const std::vector<Plane3d>&,
                                                    const StepSettingsd&);
template Truth<NextState<Rational>> simulation_step(const std::vector<StepBody<Rational>>&,
                                                    const std::vector<Plane<Rational>>&, const StepSettings<Rational>&);

}  // namespace touchstone::oracle
