// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation_of_steps.h"
#include "oracle/exact/numbers/rational_validation_of_bodies.h"

/// Validation in rationals of the parts of a step: the rules of geometry/validation_of_steps.h.
namespace touchstone::validation {

inline void validate(const std::string& field, const StepBody<oracle::Rational>& body) {
  require_inverse_mass(!negative(body.inverse_mass), field + ".inverse_mass");
  const auto& [x, y, z] = body.velocity;
  require_stillness(!zero(body.inverse_mass) || (zero(x) && zero(y) && zero(z)), field + ".velocity");
  validate(field + ".sphere", body.sphere);
}
inline void validate(const std::string& field, const StepSettings<oracle::Rational>& settings) {
  validate_restitution(field + ".restitution", settings.restitution);
  require_timestep(sgn(settings.timestep) > 0, field + ".timestep");
}

}  // namespace touchstone::validation
