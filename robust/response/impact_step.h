// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/impacts.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// One step of balls among walls that collide when they meet: the times at which they collide, which of them do, their
/// positions at the end of the step, and their velocities then. Nothing passes through anything, however fast it is.
/// All contacts at one time are resolved at once, with the velocities of least change; so neither the order of bodies
/// nor that of walls matters. Separating contacts are left alone, and nothing is pushed apart.
///
/// The pairs that meet, and their order, are decided exactly. A colliding body keeps 53 digits of its position and
/// velocity at each time; everything else is exact, and every number of the answer is the double nearest to that, for
/// all finite doubles in every floating-point environment; beyond the range it is infinite, and zero is +0. A step with
/// more than 16 times of collision is not computed to its end, nor one with more than six connected contacts at an
/// irrational time: `relation` says so. Time: all pairs are tested for each time of collision, in enclosed numbers if
/// the boxes of their paths meet, and in exact arithmetic where these do not decide; contacts at a rational time take
/// as long as those of simultaneous_collisions. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do a radius below 0 ("radius >= 0"), an inverse mass below 0 ("inverse mass >= 0"), a velocity
/// of a body that never moves ("0 where the inverse mass is 0"), a wall's normal of length 0 ("nonzero normal"), a
/// restitution out of bounds ("between 0 and 1") and a timestep of 0 or less ("timestep > 0"). Contract:
/// reference/response/impact_step.h.
ImpactStepd impact_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
                        double timestep);

namespace stages {

struct impact_step : Signatures<decltype(robust::impact_step)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
