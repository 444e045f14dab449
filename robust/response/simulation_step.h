// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/steps.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// One step of balls among walls: their positions after it, their velocities then, and the contacts at its end.
/// Contacts are found exactly and resolved all at once, with the velocities of least change; so neither the order of
/// bodies nor that of walls matters. Separating contacts are left alone, and nothing is pushed apart.
///
/// Every number is the double nearest to the one that exact arithmetic has at the end of the step, for all finite
/// doubles in every floating-point environment; beyond the range it is infinite, and zero is +0.
/// Time: all pairs are tested, and n contacts connected by movable bodies take up to n^3 operations on integers, which
/// grow with n; enclosed numbers decide most steps of few contacts.
/// NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a radius below 0 ("radius >=
/// 0"), an inverse mass below 0 ("inverse mass >= 0"), a velocity of a body that never moves ("0 where the inverse mass
/// is 0"), a wall's normal of length 0 ("nonzero normal"), a timestep of 0 or less ("timestep > 0") and a restitution
/// out of bounds ("between 0 and 1"). Contract: reference/response/simulation_step.h.
NextStated simulation_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                           const StepSettingsd& settings);

namespace stages {

struct simulation_step : Signatures<decltype(robust::simulation_step)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
