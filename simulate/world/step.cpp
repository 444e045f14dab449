// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/step.h"

#include <algorithm>

#include "catalogue/numbers/kept_digits.h"
#include "reference/response/impact_step.h"
#include "simulate/world/drawn_point.h"
#include "simulate/world/energy.h"

namespace touchstone::simulate {
namespace {

template <class Real>
double as_double(const Real& x) {
  if constexpr (std::is_same_v<Real, Exact>) return catalogue::nearest(x.value());
  else return static_cast<double>(x);
}

template <class Real>
bool finite(const State<Real>& state) {
  if constexpr (std::is_same_v<Real, Exact>) return true;
  for (const auto& [p, v] : state)
    for (const Real& x : {p.x, p.y, p.z, v.x, v.y, v.z})
      if (!std::isfinite(as_double(x))) return false;
  return true;
}

template <class By>
class Step {
 public:
  using Real = typename By::Number;

  Step(const World<By>& world, const State<Real>& state, const std::vector<Impact>* follow, Log* log, Nearby& nearby)
      : world_(world), settings_(world.settings()), follow_(follow), log_(log), nearby_(nearby), state_(state) {}

  Stepped<Real> made() {
    const bool accelerates_first = settings_.motion == Motion::accelerate_then_move;
    const bool turns_first = settings_.turn == Turn::before_move;
    if (accelerates_first) accelerate();
    if (settings_.option == 2) {
      if (curved()) look_for_carriers();
      fly();
    } else {
      if (turns_first) answer_contacts(moved(world_.timestep()));
      state_ = moved(world_.timestep());
    }
    if (!accelerates_first && !curved()) accelerate();
    if (settings_.option == 1 && !turns_first) answer_contacts(State<Real>(state_));
    if (!finite(state_)) throw StepError("a number is beyond the range");
    return {std::move(state_), std::move(impacts_), std::move(law_)};
  }

 private:
  struct Moment {
    Touch touch;
    Real time;  ///< a fraction of the rest of the step
    Vector3<Real> normal;
  };

  /// True if velocities change in flight.
  bool curved() const { return settings_.option == 2 && settings_.motion == Motion::parabola; }

  Vector3<Real> acceleration(std::size_t body) const {
    if (curved()) return pulls_[body];
    Vector3<Real> sum = world_.gravity();
    if (settings_.law != Law::penalty) return sum;
    const Real stiffness = By::number(settings_.stiffness), damping = By::number(settings_.damping);
    const auto& [p, v] = state_[body];
    for (std::size_t wall = 0; wall < world_.walls(); ++wall) {
      const Real share = Real(Real(1) / world_.solid(body).mass);
      sum = plus<By>(sum, share, By::penalty_force(p, v, world_.wall(wall), stiffness, damping));
    }
    return sum;
  }

  void accelerate() {
    for (std::size_t i = 0; i < state_.size(); ++i)
      if (!world_.solid(i).fixed) state_[i].velocity = plus<By>(state_[i].velocity, world_.timestep(), acceleration(i));
  }

  /// The positions after that time, and the velocities, if they change in flight.
  State<Real> moved(const Real& time) const {
    State<Real> moved = state_;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (world_.solid(i).fixed) continue;
      Vector3<Real> v = state_[i].velocity;
      if (settings_.motion == Motion::parabola) v = plus<By>(v, Real(time / Real(2)), acceleration(i));
      moved[i].position = plus<By>(moved[i].position, time, v);
      if (curved()) moved[i].velocity = plus<By>(moved[i].velocity, time, acceleration(i));
    }
    return moved;
  }

  /// `left`: the rest of the step.
  void answer(const Touch& touch, const Vector3<Real>& normal, const State<Real>& at, double time, const Real& left) {
    const mpq_class before = kinetic_energy(touch);
    world_.respond(touch, state_, normal);
    const double rise = world_.rise(touch, state_);
    const bool ends = curved() && touch.wall && world_.comes_to_rest(touch, state_, pulls_[touch.body], left);
    if (ends) {
      Vector3<Real>& v = state_[touch.body].velocity;
      v = By::damped_reflection(v, normal, Real(0));
    }
    law_ += kinetic_energy(touch) - before;
    if (curved()) {
      look_for_carriers(touch.body, ends ? touch.other : world_.walls());
      if (!touch.wall) look_for_carriers(touch.other, world_.walls());
    }
    const Vector3d n{as_double(normal.x), as_double(normal.y), as_double(normal.z)};
    impacts_.push_back({touch, time, drawn_point(world_, touch, at, n), n, rise});
  }

  /// Finds the walls that carry a body: those on which it rests, and that one.
  void look_for_carriers(std::size_t body, std::size_t wall) {
    std::vector<std::size_t>& carriers = carriers_[body];
    carriers.clear();
    for (std::size_t w = 0; w < world_.walls(); ++w)
      if (w == wall || world_.rests({true, body, w}, state_)) carriers.push_back(w);
    pulls_[body] = world_.carried(carriers);
  }
  void look_for_carriers() {
    carriers_.resize(world_.bodies()), pulls_.resize(world_.bodies());
    for (std::size_t i = 0; i < world_.bodies(); ++i) look_for_carriers(i, world_.walls());
  }
  bool carries(const Touch& touch) const {
    if (!curved() || !touch.wall) return false;
    const std::vector<std::size_t>& carriers = carriers_[touch.body];
    return std::find(carriers.begin(), carriers.end(), touch.other) != carriers.end();
  }

  /// The pairs that may meet during the rest of the step.
  const std::vector<Touch>& touches(const Real& left) const {
    const State<Real> end = moved(left);
    if (!curved()) return world_.touches(state_, end, nearby_);
    const double eighth = as_double(left) * as_double(left) / 8;
    const Vector3<Real>& g = world_.gravity();
    const Vector3d sag{std::abs(as_double(g.x)) * eighth, std::abs(as_double(g.y)) * eighth,
                       std::abs(as_double(g.z)) * eighth};
    const auto one_pull = [&](std::size_t i, std::size_t j) {
      const Vector3<Real>&a = pulls_[i], &b = pulls_[j];
      return a.x == b.x && a.y == b.y && a.z == b.z;
    };
    const bool all_fall =
        std::all_of(carriers_.begin(), carriers_.end(), [](const auto& some) { return some.empty(); });
    if (all_fall) return world_.touches(state_, end, nearby_, settings_.broad_phase, sag);
    for (const Touch& touch : world_.touches(state_, end, nearby_, BroadPhase::sort_and_sweep, sag))
      if (!touch.wall && !one_pull(touch.body, touch.other))
        throw StepError("bodies[" + std::to_string(touch.body) + "] and bodies[" + std::to_string(touch.other) +
                        "] come near each other, one at rest on a wall and one in free fall: when they meet is a root "
                        "of a polynomial of degree 4, which is not answered");
    return world_.touches(state_, end, nearby_, settings_.broad_phase, sag);
  }

  /// The energy of the two bodies of a contact, in Exact only; otherwise 0.
  mpq_class kinetic_energy(const Touch& touch) const {
    mpq_class sum = 0;
    if constexpr (std::is_same_v<Real, Exact>) {
      const auto add = [&](std::size_t body) {
        const auto& solid = world_.solid(body);
        if (!solid.fixed) sum += simulate::kinetic_energy(solid.mass.value(), state_[body].velocity);
      };
      add(touch.body);
      if (!touch.wall) add(touch.other);
    }
    return sum;
  }

  // Option 1.
  void answer_contacts(const State<Real>& at) {
    if (follow_ != nullptr) {
      for (const Impact& impact : *follow_)
        if (const auto normal = world_.normal(impact.touch, at)) answer(impact.touch, *normal, at, 1, Real(0));
      return;
    }
    if (settings_.law == Law::penalty) return;
    const std::vector<Touch>& touches = world_.touches(at, at, nearby_);
    for (std::uint32_t pass = 0; pass < settings_.passes; ++pass) {
      for (const Touch& touch : touches) {
        if (!world_.meet(touch, at, log_)) continue;
        const auto normal = world_.normal(touch, at);
        if (normal && world_.approach(touch, state_, *normal, log_)) answer(touch, *normal, at, 1, Real(0));
      }
    }
  }

  // Option 2.
  void fly() {
    Real left = world_.timestep();
    const auto gone = [&] { return as_double(Real(Real(world_.timestep() - left) / world_.timestep())); };
    while (const auto moment = follow_ == nullptr ? first_moment(left) : followed(left, gone())) {
      if (impacts_.size() == settings_.moments)
        throw StepError("more than " + std::to_string(settings_.moments) + " moments (advance.moments)" +
                        (curved() ? "; bounces that end within the step are no more than one, others are" : ""));
      const Real time = Real(moment->time * left);
      state_ = moved(time);
      left = Real(left - time);
      Vector3<Real> normal = moment->normal;
      if (!impacts_.empty()) {
        left = reference::between_moments(left);
        if (shorten(moment->touch)) normal = world_.normal(moment->touch, state_).value_or(normal);
      }
      answer(moment->touch, normal, state_, gone(), left);
    }
    state_ = moved(left);
  }

  /// Shortens to 53 digits the numbers that bodies of the touch have from earlier events of this step, like
  /// impact_step, or digits would multiply with every bounce; numbers of 53 digits stay. Returns whether there was any
  /// to shorten.
  bool shorten(const Touch& touch) {
    const auto shortened = [this](std::size_t body) {
      const auto met = [body](const Impact& impact) {
        return impact.touch.body == body || (!impact.touch.wall && impact.touch.other == body);
      };
      if (std::none_of(impacts_.begin(), impacts_.end(), met)) return false;
      auto& [p, v] = state_[body];
      for (Real* x : {&p.x, &p.y, &p.z, &v.x, &v.y, &v.z}) *x = reference::between_moments(*x);
      return true;
    };
    const bool first = shortened(touch.body);
    return (!touch.wall && shortened(touch.other)) || first;
  }

  std::optional<Moment> first_moment(const Real& left) const {
    std::optional<Moment> first;
    for (const Touch& touch : touches(left)) {
      const bool falls = curved() && touch.wall;
      // Two bodies that just bounced do not meet again before another contact has changed one of them; but a falling
      // body returns to a wall, unless that carries it.
      if (falls ? carries(touch) : !impacts_.empty() && impacts_.back().touch == touch) continue;
      const auto moment = moment_of(touch, left);
      if (!moment || (first && !(moment->time < first->time))) continue;
      if (falls || world_.approach(touch, state_, moment->normal, log_)) first = moment;
    }
    return first;
  }

  std::optional<Moment> moment_of(const Touch& touch, const Real& left) const {
    Real time = Real(0);
    if (curved() && touch.wall) {
      const auto fall = world_.first_fall(touch, state_, pulls_[touch.body], left);
      if (fall.relation == HitRelation::never) return std::nullopt;
      time = By::moment(*fall.t);
    } else if (!world_.meet(touch, state_, log_)) {
      const auto hit = world_.first_meeting(touch, state_, left, log_);
      if (hit.relation == HitRelation::never) return std::nullopt;
      time = By::moment(*hit.t);
    }
    const auto normal = world_.normal(touch, moved(Real(time * left)));
    if (!normal) return std::nullopt;
    return Moment{touch, time, *normal};
  }

  std::optional<Moment> followed(const Real& left, double gone) const {
    if (impacts_.size() == follow_->size()) return std::nullopt;
    const Impact& impact = (*follow_)[impacts_.size()];
    if (auto moment = moment_of(impact.touch, left)) return moment;
    const double late = impact.time - gone, rest = 1 - gone;
    const Real time = By::number(late > 0 && rest > 0 ? std::min(late / rest, 1.0) : 0.0);
    const auto normal = world_.normal(impact.touch, moved(Real(time * left)));
    return Moment{impact.touch, time, normal.value_or(catalogue::converted<Real>(impact.normal, By::number))};
  }

  const World<By>& world_;
  const Settings& settings_;
  const std::vector<Impact>* follow_;
  Log* log_;
  Nearby& nearby_;
  State<Real> state_;
  std::vector<Impact> impacts_;
  mpq_class law_ = 0;
  // For each body, if velocities change in flight: the walls that carry it, and the acceleration that these leave.
  std::vector<std::vector<std::size_t>> carriers_;
  std::vector<Vector3<Real>> pulls_;
};

}  // namespace

template <class By, class Real>
Stepped<Real> step(const World<By>& world, const State<Real>& state, const std::vector<Impact>* follow, Log* log,
                   Nearby* nearby) {
  Nearby own;
  return Step<By>(world, state, follow, log, nearby == nullptr ? own : *nearby).made();
}

template Stepped<float> step(const World<Formulas<float>>&, const State<float>&, const std::vector<Impact>*, Log*,
                             Nearby*);
template Stepped<double> step(const World<Formulas<double>>&, const State<double>&, const std::vector<Impact>*, Log*,
                              Nearby*);
template Stepped<Exact> step(const World<Formulas<Exact>>&, const State<Exact>&, const std::vector<Impact>*, Log*,
                             Nearby*);
template Stepped<double> step(const World<Robust>&, const State<double>&, const std::vector<Impact>*, Log*, Nearby*);

}  // namespace touchstone::simulate
