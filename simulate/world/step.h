// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "simulate/world/world.h"

namespace touchstone::simulate {

/// A contact that a step answered, as doubles: for files, pages, and a step that has to follow it.
struct Impact {
  Touch touch;
  double time;      ///< 0 to 1 of the step; with option 1 always 1
  Point3d point;    ///< approximate, for drawings: decides nothing
  Vector3d normal;  ///< from the other body, or the wall
  double rise = 0;  ///< the height above a wall to which the velocity after the contact brings the body
};

template <class Real>
struct Stepped {
  State<Real> state;
  std::vector<Impact> impacts;  ///< in the order of their responses
  mpq_class law = 0;            ///< the change of kinetic energy by the responses; for a step in Exact only
};

/// A step that cannot be made: a number is out of range, or there are more events than the scene allows.
struct StepError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One step of the scene, from deck p. 9, 23, 44-51, 56 and 64-74.
///
/// Gravity enters as `motion` says. Option 1: the contacts at the end of the step, pairs i < j first, then bodies and
/// walls, each answered in that order, `passes` times; a contact is a touch (closed sets) whose bodies approach along
/// its normal, judged by their current velocities. With `before_move` velocities change and bodies then move from where
/// they were; with `after_move` they have moved. Option 2: bodies fly along lines to the least time at which two of
/// them meet and approach, or at once if they meet already; of several such contacts the first in the order is
/// answered, and the others follow at the same time. Between contacts each body's numbers are of the arithmetic:
/// rounded once per operation, or never. With `parabola` and option 2 bodies fly along parabolas; bodies of equal
/// acceleration meet as if they flew along lines, and a height above a wall is quadratic. A body whose bounces from one
/// wall would all end within the step, infinitely many if e < 1, makes one of them, and rests: the wall carries it from
/// then on, so that it moves along the wall, until another contact changes its velocity; so does one that touches a
/// wall without leaving it while gravity presses. A body at rest and one that falls do not meet: StepError. Springs (p.
/// 72-73) act with gravity, from the state at the start.
///
/// `follow`: these contacts are answered instead of those that the step would find; throws if one does not occur at its
/// recorded time. `log`: receives the questions asked. `nearby`: kept for the next step, which is then faster. Throws
/// StepError, and what robust throws.
template <class By, class Real = typename By::Number>
Stepped<Real> step(const World<By>& world, const State<Real>& state, const std::vector<Impact>* follow = nullptr,
                   Log* log = nullptr, Nearby* nearby = nullptr);

}  // namespace touchstone::simulate
