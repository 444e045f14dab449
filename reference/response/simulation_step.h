// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/steps.h"

namespace touchstone::reference {

/// Positions, velocities and contacts of balls after one step of time: the deck as one running system.
///
/// Deck p. 23 (option 1: contacts are looked for at the end of the step), 55-56 (the loop over all pairs), 64-71 and 74
/// (the response). No page asks the question; the step is put together from theirs: motion of p. 9, balls and planes
/// as on p. 44-50, the impulse of p. 69-70, all contacts at once as on p. 74 (simultaneous_collisions).
///
/// 1. Every body that can move flies freely to the end of the step, as `motion` says (StepMotion).
/// 2. A contact is a pair of bodies, not both immovable, or a movable body and a wall, that have a common point there
///    (closed sets: a touch is enough), and do not part: n . (va - vb) <= 0, with the normal n of the contact, from the
///    second to the first. For two balls n leads from center to center; where centers coincide there is no normal, and
///    the pair is no contact, as are two particles. For a wall n is its normal. With `before_move` the velocities are
///    those with which bodies fly: after gravity with accelerate_then_move, before it otherwise. With `after_move` they
///    are those at the end of the step.
/// 3. The velocities of bodies in contact become those of least change, the sum of m |v' - v|^2, with which every
///    contact leaves at e times the speed of its approach at least: n . (va' - vb') >= -e n . (va - vb). A contact at
///    rest (n . (va - vb) = 0) must not approach afterwards; it is answered with the others, so that a stack that
///    lands comes entirely to rest with e = 0. Such velocities exist, for -e v meets every demand, and they are
///    unique. Contacts that share no movable body do not change each other. The order of bodies and walls does not
///    matter: the answer is permuted with them. Momentum is kept where no immovable body or wall is in contact; energy
///    is not gained by the response, and not lost if e = 1.
/// 4. With `after_move` bodies stay where they are. With `before_move` they fly from where they were before with their
///    new velocities; so two that would have met need not touch. Gravity then enters as in step 1.
///
/// Nothing is pushed apart: bodies that overlap, at the start or at the end, and part are left alone, as are a body
/// behind a wall and one that leaves it. A body that passes through another within the step is not noticed (p. 23).
/// The answer: contacts, each by two places, the smaller first, in ascending order; wall k has the place n + k where
/// there are n bodies. For each body its position and velocity after the step. Every number is computed from the
/// question without rounding, and rounded once; beyond the range it is infinite, and zero is +0.
///
/// bodies, walls: any number, none too. inverse_mass: 0 or more, in any unit; a body of 0 never moves, and gravity does
/// not pull it. velocity: lengths per unit of time. sphere: any unit of length, radius 0 is a particle. walls: the
/// solid is where normal . p + offset <= 0; the normal has any length but 0. settings: timestep in that unit of time,
/// more than 0; gravity in lengths per its square; restitution from 0 to 1, without unit, the same for all contacts.
/// NaN or infinity: refused by robust and oracle (field "bodies[0].sphere.center[0]" ..., "finite number"); so are an
/// inverse mass below 0 ("bodies[0].inverse_mass", "inverse mass >= 0"), an immovable body with a velocity
/// ("bodies[0].velocity", "0 where the inverse mass is 0"), a radius below 0 ("bodies[0].sphere.radius", "radius >=
/// 0"), a wall's normal of length 0 ("walls[0].normal", "nonzero normal"), a restitution out of bounds
/// ("settings.restitution", "between 0 and 1") and a timestep of 0 or less ("settings.timestep", "timestep > 0"). The
/// first is named: all numbers before all else, then body after body, wall after wall, and the settings.
///
/// Not here: option 2 of p. 23, boxes, friction, bodies that turn, and the springs of p. 72-73.
///
/// Method (the loop of p. 56): pairs i < j in ascending order, walls as the last objects; each contact is answered when
/// its turn comes, by the impulse of p. 69-70, from the velocities that earlier ones have left. Where a body meets two
/// others, though it may part from one of them, the answer depends on the order, a contact may approach afterwards, and
/// others are found than there are (cause: algorithm). Otherwise it is right in exact arithmetic.
///
/// Rounding: rounded positions, and differences and squares that round, decide whether bodies meet; no bound
/// is given but the one that running error analysis finds.
/// ulps: 98 roundings behind a component of two bodies in one contact with gravity (2 for a velocity; 2 more for a
/// position and 1 for a difference, three of them in n . (va - vb) with 14 each and 5 of its own, and 32 in n . n; 6
/// for the impulse, 10 for its part along n, 1 for the velocity, 2 for the position).
template <class Real>
NextState<Real> simulation_step(const std::vector<StepBody<Real>>& bodies, const std::vector<Plane<Real>>& walls,
                                const StepSettings<Real>& settings) {
  const Real &h = settings.timestep, &e = settings.restitution;
  const Vector3<Real>& gravity = settings.gravity;
  const bool before_move = settings.turn == StepTurn::before_move;
  const bool gravity_first = settings.motion == StepMotion::accelerate_then_move;
  const bool parabola = settings.motion == StepMotion::parabola;
  NextState<Real> next;
  std::vector<Vector3<Real>> v;
  for (const StepBody<Real>& body : bodies) v.push_back(body.velocity);
  const auto moves = [&](std::size_t i) { return bodies[i].inverse_mass > Real(0); };
  const auto accelerate = [&] {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (moves(i)) v[i] = v[i] + h * gravity;
  };
  const auto flown = [&] {
    std::vector<Point3<Real>> at;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Vector3<Real> mean = parabola ? v[i] + Real(h / Real(2)) * gravity : v[i];
      at.push_back(moves(i) ? bodies[i].sphere.center + h * mean : bodies[i].sphere.center);
    }
    return at;
  };
  const auto answer = [&](std::size_t i, std::size_t j, const Vector3<Real>& n) {
    const bool wall = j >= bodies.size();
    const Real square = Real(dot(n, n)), parting = Real(dot(n, wall ? v[i] : v[i] - v[j]));
    if (!(square > Real(0)) || parting > Real(0)) return;
    next.contacts.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    const Real wi = bodies[i].inverse_mass, wj = wall ? Real(0) : bodies[j].inverse_mass, both = Real(wi + wj);
    const Real impulse = Real(-Real(Real(Real(1) + e) * parting) / Real(both * square));
    v[i] = v[i] + Real(wi * impulse) * n;
    if (!wall) v[j] = v[j] - Real(wj * impulse) * n;
  };
  if (gravity_first) accelerate();
  const std::vector<Point3<Real>> at = flown();
  if (!gravity_first && !before_move) accelerate();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      if (!moves(i) && !moves(j)) continue;
      const Vector3<Real> apart = at[i] - at[j];
      const Real reach = Real(bodies[i].sphere.radius + bodies[j].sphere.radius);
      if (Real(dot(apart, apart)) <= Real(reach * reach)) answer(i, j, apart);
    }
    for (std::size_t k = 0; k < walls.size() && moves(i); ++k) {
      const auto& [n, offset] = walls[k];
      const Point3<Real>& p = at[i];
      const Real height = Real(dot(n, Vector3<Real>{p.x, p.y, p.z}) + offset), r = bodies[i].sphere.radius;
      if (height <= Real(0) || Real(height * height) <= Real(Real(r * r) * dot(n, n))) answer(i, bodies.size() + k, n);
    }
  }
  const std::vector<Point3<Real>> end = before_move ? flown() : at;
  if (!gravity_first && before_move) accelerate();
  for (std::size_t i = 0; i < bodies.size(); ++i) next.bodies.push_back({end[i], v[i]});
  return next;
}

}  // namespace touchstone::reference
