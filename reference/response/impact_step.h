// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "geometry/impacts.h"

namespace touchstone::reference {

/// The precision of a number between times of collision: see the contract of impact_step. A type with more digits than
/// 53 says by a function of that name how it leaves the others out; floating-point numbers have no others.
template <class Real>
Real between_moments(const Real& number) {
  if constexpr (requires { kept_digits(number); }) return kept_digits(number);
  else return number;
}

/// Positions and velocities of balls after one step of time in which they collide when they meet: option 2 of p. 23, of
/// which simulation_step is option 1.
///
/// Deck p. 23 (option 2: the time of impact within the step), 51 (when two balls that move along lines first meet),
/// 55-56 (the loop over all pairs), 64-71 and 74 (the response). No page asks the question; the step is put together
/// from theirs. t counts in steps, from 0 to 1.
///
/// 1. A body flies along a straight line: with position p and velocity v at its clock c, which is 0 at first, it is at
///    p + (t - c) h v, where h is the timestep. There is no gravity here. Where the velocity changes before bodies
///    move, or after (accelerate_then_move, move_then_accelerate of simulation_step), the caller adds h g to it;
///    under a parabola the first time of contact with a body that never moves would be a root of a polynomial of
///    degree 4.
/// 2. A pair of bodies, not both immovable, or a movable body and a wall, collides at the first t, from the later of
///    its two clocks to 1, at which it meets and approaches. It meets where it has a common point (closed sets: a
///    touch is enough; behind a wall is in its solid), and approaches where n . (va - vb) < 0 with the normal n of the
///    contact: from the second center to the first, or that of the wall. So a pair that overlaps, at the start or
///    after a moment, collides at once if it approaches, and never if it does not; where balls graze, n . (va - vb) =
///    0, they do not collide; nor do two whose centers coincide, for there is no normal, nor two particles. t = 0 and
///    t = 1 count.
/// 3. The next moment is the least t at which pairs collide. Its contacts are all pairs, with clocks not after t, that
///    meet at t and do not part, n . (va - vb) <= 0, as far as they are connected, by movable bodies, to one that
///    collides; others are left alone. Their velocities become those of least change, as in simulation_step: the
///    sum of m |v' - v|^2 is the least with which each contact leaves at e times the speed of its approach at least. A
///    contact at rest is answered with the others, so that a moment has no order of its own. The order of bodies and
///    walls does not matter.
/// 4. Position at t, velocity and clock of each movable body in those contacts become the nearest numbers of 53 binary
///    digits (ties to the even one; the exponent has no bounds): what a double holds. All other numbers are exact, t
///    too: a root of a quadratic polynomial, p + q sqrt(r), as are positions and velocities before they are rounded.
///    Were they not, each moment would double the degree, and their digits.
/// 5. A contact that was answered is settled: it does not collide again before one of its two, as a body that can move,
///    is in a moment without it. In exact arithmetic nothing else could happen, for it does not approach and bodies fly
///    straight; so rounded velocities cannot make it collide with itself over and over.
/// Then step 2 again, with the rest of the time. The answer: the moments, each with the exact t, not its rounded clock,
/// and with its contacts, named as in simulation_step, in ascending order; and for each body its position at t = 1 and
/// its velocity there. Each number is rounded once from that; beyond the range it is infinite, and zero is +0.
///
/// bodies, walls, restitution, timestep: as in simulation_step. NaN or infinity: refused by robust and oracle (field
/// "bodies[0].sphere.center[0]" ..., "finite number"); so are an inverse mass below 0 ("bodies[0].inverse_mass",
/// "inverse mass >= 0"), an immovable body with a velocity ("bodies[0].velocity", "0 where the inverse mass is 0"), a
/// radius below 0 ("bodies[0].sphere.radius", "radius >= 0"), a wall's normal of length 0 ("walls[0].normal",
/// "nonzero normal"), a restitution out of bounds ("restitution", "between 0 and 1") and a timestep of 0 or less
/// ("timestep", "timestep > 0"). The first is named: all numbers before all else, then body after body, wall after
/// wall, and the rest. Conditions that only the course of the step reveals are answers: `finished`; `too_many_moments`
/// after sixteen, if another would follow (three balls in a row can have infinitely many if e < 7 - 4 sqrt(3));
/// `too_many_contacts` at a moment that is no rational number if more than six of its contacts are connected: it is the
/// last of the moments, and not answered. Where the step is not finished, no state of its end is given.
///
/// Not here: gravity, boxes, friction, bodies that turn, springs.
///
/// Method (p. 56 once more): each pair's t by the quadratic formula; those of the least t are answered, each by the
/// impulse of p. 69-70. Bodies at rest with one that collides are ignored, and each contact of a body in two is
/// answered as if the other were not there (cause: algorithm). Contacts are never too many to it. Otherwise it is right
/// in exact arithmetic, with 53 digits between moments.
///
/// Rounding: a discriminant that cancels decides whether a pair meets; no bound is given except the one that running
/// error analysis finds.
/// ulps: 94 roundings behind a position after one moment of two balls (16 for their places, 3 for a difference, 6 for
/// w, 1 for the reach, 5 for w . w, 5 for the slope, 7 for the gap, 3 for the discriminant, 4 for t; again 16 and 3
/// at t, 5 for n . n, 8 for n . (va - vb), 5 for the impulse, 3 for the velocity and 4 for the position).
template <class Real>
ImpactStep<Real> impact_step(const std::vector<StepBody<Real>>& bodies, const std::vector<Plane<Real>>& walls,
                             const Real& restitution, const Real& timestep) {
  using std::sqrt;
  struct Flight {
    Point3<Real> position;
    Vector3<Real> velocity;
    Real clock;
  };
  const Real &h = timestep, &e = restitution;
  const std::size_t n = bodies.size();
  std::vector<Flight> at;
  for (const StepBody<Real>& body : bodies) at.push_back({body.sphere.center, body.velocity, Real(0)});
  const auto moves = [&](std::size_t i) { return bodies[i].inverse_mass > Real(0); };
  const auto place = [&](std::size_t i, const Real& t) {
    const Real passed = Real(Real(t - at[i].clock) * h);
    return moves(i) ? at[i].position + passed * at[i].velocity : at[i].position;
  };
  const auto collides_at = [&](std::size_t i, std::size_t j) -> std::optional<Real> {
    std::optional<Real> t;
    if (j >= n) {
      const auto& [normal, offset] = walls[j - n];
      const Real start = at[i].clock, slope = Real(h * Real(dot(normal, at[i].velocity)));
      const auto [x, y, z] = place(i, start);
      const Real height = Real(dot(normal, Vector3<Real>{x, y, z}) + offset);
      const Real gap = Real(height - Real(bodies[i].sphere.radius * Real(sqrt(Real(dot(normal, normal))))));
      if (!(slope < Real(0))) return std::nullopt;
      t = gap <= Real(0) ? start : Real(start - Real(gap / slope));
    } else {
      const Real start = at[i].clock < at[j].clock ? at[j].clock : at[i].clock;
      const Vector3<Real> apart = place(i, start) - place(j, start), w = h * (at[i].velocity - at[j].velocity);
      const Real reach = Real(bodies[i].sphere.radius + bodies[j].sphere.radius);
      const Real slope = Real(dot(apart, w)), gap = Real(dot(apart, apart) - Real(reach * reach));
      if (!(slope < Real(0))) return std::nullopt;
      t = start;
      if (!(gap <= Real(0))) {
        const Real square = Real(dot(w, w)), discriminant = Real(Real(slope * slope) - Real(square * gap));
        if (!(discriminant > Real(0))) return std::nullopt;
        t = Real(start + Real(Real(-slope - Real(sqrt(discriminant))) / square));
      }
    }
    if (*t <= Real(1)) return t;
    return std::nullopt;
  };
  const auto answered = [&](std::size_t i, std::size_t j, const Real& t) {
    const bool wall = j >= n;
    const Vector3<Real> normal = wall ? walls[j - n].normal : place(i, t) - place(j, t);
    const Vector3<Real>& v = at[i].velocity;
    const Real square = Real(dot(normal, normal)), parting = Real(dot(normal, wall ? v : v - at[j].velocity));
    const Real wi = bodies[i].inverse_mass, wj = wall ? Real(0) : bodies[j].inverse_mass, both = Real(wi + wj);
    const Real impulse = Real(-Real(Real(Real(1) + e) * parting) / Real(both * square));
    std::pair<Vector3<Real>, Vector3<Real>> change{Real(wi * impulse) * normal, Real(wj * impulse) * normal};
    return change;
  };
  ImpactStep<Real> step{StepCourse::finished, {}, std::nullopt};
  std::set<std::pair<std::size_t, std::size_t>> settled;
  for (;;) {
    std::optional<Real> first;
    std::vector<std::pair<std::size_t, std::size_t>> met;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n + walls.size(); ++j) {
        const bool one_moves = moves(i) || (j < n && moves(j));
        if (!one_moves || settled.count({i, j}) != 0) continue;
        const std::optional<Real> t = collides_at(i, j);
        if (!t || (first && *first < *t)) continue;
        if (!first || *t < *first) met.clear();
        first = t, met.push_back({i, j});
      }
    }
    if (!first) break;
    if (step.moments.size() == most_moments) {
      step.relation = StepCourse::too_many_moments;
      return step;
    }
    std::vector<Vector3<Real>> after;
    for (const Flight& flight : at) after.push_back(flight.velocity);
    std::set<std::size_t> touched;
    std::vector<Point3<Real>> places;
    for (std::size_t i = 0; i < n; ++i) places.push_back(place(i, *first));
    Moment<Real> moment{*first, {}};
    for (const auto& [i, j] : met) {
      const auto [change, other] = answered(i, j, *first);
      for (const std::size_t body : {i, j})
        if (body < n && moves(body)) touched.insert(body);
      after[i] = after[i] + change;
      if (j < n) after[j] = after[j] - other;
      moment.contacts.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    }
    std::erase_if(settled,
                  [&](const auto& pair) { return touched.count(pair.first) != 0 || touched.count(pair.second) != 0; });
    settled.insert(met.begin(), met.end());
    for (const std::size_t i : touched) {
      const auto& [x, y, z] = places[i];
      const Vector3<Real>& v = after[i];
      at[i].position = {between_moments(x), between_moments(y), between_moments(z)};
      at[i].velocity = {between_moments(v.x), between_moments(v.y), between_moments(v.z)};
      at[i].clock = between_moments(*first);
    }
    step.moments.push_back(std::move(moment));
  }
  step.bodies.emplace();
  for (std::size_t i = 0; i < n; ++i) step.bodies->push_back({place(i, Real(1)), at[i].velocity});
  return step;
}

}  // namespace touchstone::reference
