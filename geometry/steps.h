// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/space.h"
#include "geometry/volumes.h"

namespace touchstone {

/// How gravity g enters a step of length h, which the deck leaves open. From p with velocity v, a free body comes to
/// p + h v + h^2 g, to p + h v, or to p + h v + h^2 g / 2; its velocity is v + h g then.
enum class StepMotion { accelerate_then_move, move_then_accelerate, parabola };
constexpr auto words_of(StepMotion) { return as_words("accelerate_then_move", "move_then_accelerate", "parabola"); }

/// Velocities change before bodies move to the places of their contacts, or after.
enum class StepTurn { before_move, after_move };
constexpr auto words_of(StepTurn) { return as_words("before_move", "after_move"); }

/// A ball that does not turn; a particle has the radius 0. inverse_mass 0 is a body that never moves: its velocity is
/// 0, any other is refused. So is a negative inverse mass.
template <class Real>
struct StepBody {
  Real inverse_mass;
  Vector3<Real> velocity;
  Sphere3<Real> sphere;
  static constexpr auto members = as_record("inverse_mass", "velocity", "sphere");
  bool rules(const auto& check) const {
    const bool fixed = validation::zero(inverse_mass);
    return check("inverse_mass", rule::inverse_mass(inverse_mass)) &&
           check("velocity", {!fixed || validation::still(velocity), "0 where the inverse mass is 0"}) &&
           check.part("sphere", sphere);
  }
};

/// A restitution below 0 or above 1 is refused, and a timestep of 0 or less.
template <class Real>
struct StepSettings {
  Vector3<Real> gravity;
  StepMotion motion;
  Real restitution, timestep;
  StepTurn turn;
  static constexpr auto members = as_record("gravity", "motion", "restitution", "timestep", "turn");
  bool rules(const auto& check) const {
    return check("restitution", rule::restitution(restitution)) && check("timestep", rule::timestep(timestep));
  }
};

template <class Real>
struct BodyState {
  Point3<Real> position;
  Vector3<Real> velocity;
  static constexpr auto members = as_record("position", "velocity");
};

/// A contact is named by the places of its two bodies, the smaller first. Walls count on where bodies end: of n bodies,
/// wall 0 has the place n.
template <class Real>
struct NextState {
  std::vector<IndexPair> contacts;
  std::vector<BodyState<Real>> bodies;
  static constexpr auto members = as_record("contacts", "bodies");
};

using StepBodyd = StepBody<double>;
using StepSettingsd = StepSettings<double>;
using BodyStated = BodyState<double>;
using NextStated = NextState<double>;

}  // namespace touchstone
