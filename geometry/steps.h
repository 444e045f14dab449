// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/space.h"
#include "geometry/volumes.h"

namespace touchstone {

/// How gravity g enters a step of length h, which the deck leaves open. From p with velocity v, a free body comes to
/// p + h v + h^2 g, to p + h v, or to p + h v + h^2 g / 2; its velocity is v + h g then.
enum class StepMotion { accelerate_then_move, move_then_accelerate, parabola };

/// Whether velocities change before bodies move to where contacts were found, or there.
enum class StepTurn { before_move, after_move };

/// A ball that does not turn; a particle has the radius 0. inverse_mass 0 is a body that never moves: its velocity is
/// 0, any other is refused. So is a negative inverse mass.
template <class Real>
struct StepBody {
  Real inverse_mass;
  Vector3<Real> velocity;
  Sphere3<Real> sphere;
};

/// A restitution below 0 or above 1 is refused, and a timestep of 0 or less.
template <class Real>
struct StepSettings {
  Vector3<Real> gravity;
  StepMotion motion;
  Real restitution, timestep;
  StepTurn turn;
};

template <class Real>
struct BodyState {
  Point3<Real> position;
  Vector3<Real> velocity;
};

/// A contact is named by the places of its two bodies, the smaller first. Walls count on where bodies end: of n bodies,
/// wall 0 has the place n.
template <class Real>
struct NextState {
  std::vector<IndexPair> contacts;
  std::vector<BodyState<Real>> bodies;
};

using StepBodyd = StepBody<double>;
using StepSettingsd = StepSettings<double>;
using BodyStated = BodyState<double>;
using NextStated = NextState<double>;

}  // namespace touchstone
