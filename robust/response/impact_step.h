// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/impacts.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// One step of balls among walls that collide when they meet: at which moments which of them do, where they are at the
/// end of the step, and how they move then. Nothing passes through anything, however fast it is. All contacts of a
/// moment are answered at once, with the velocities of least change; so neither the order of bodies nor that of walls
/// matters. What parts is left alone, and nothing is pushed apart.
///
/// Which pairs meet, and in which order, is decided exactly. What collides keeps 53 digits of its position and velocity
/// at each moment; all else is exact, and every number of the answer is the double nearest to that, for all finite
/// doubles in every floating-point environment; beyond the range it is infinite, and zero is +0. A step of more than 16
/// moments is not answered to its end, nor one with more than six contacts that hang together at an irrational moment:
/// `relation` says so.
/// Time: all pairs are looked at for each moment, in exact arithmetic where the boxes of their ways meet; contacts of a
/// rational moment take as long as those of simultaneous_collisions.
/// NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a radius below 0 ("radius >=
/// 0"), an inverse mass below 0 ("inverse mass >= 0"), a velocity of a body that never moves ("0 where the inverse mass
/// is 0"), a wall's normal of length 0 ("nonzero normal"), a restitution out of bounds ("between 0 and 1") and a
/// timestep of 0 or less ("timestep > 0"). Contract: reference/response/impact_step.h.
ImpactStepd impact_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
                        double timestep);

}  // namespace touchstone::robust
