// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/steps.h"
#include "geometry/validation_of_bodies.h"

/// Validation of what a step is made from: see validation.h.
namespace touchstone::validation {

/// The rules, for doubles and for rationals alike.
inline void require_stillness(bool holds, const std::string& field) {
  require(holds, field, "0 where the inverse mass is 0");
}
inline void require_timestep(bool holds, const std::string& field) { require(holds, field, "timestep > 0"); }

inline void validate_numbers(const std::string& field, const StepBodyd& body) {
  validate_numbers(field + ".inverse_mass", body.inverse_mass), validate_numbers(field + ".velocity", body.velocity);
  validate_numbers(field + ".sphere", body.sphere);
}
inline void validate_numbers(const std::string& field, const StepSettingsd& settings) {
  validate_numbers(field + ".gravity", settings.gravity);
  validate_numbers(field + ".restitution", settings.restitution);
  validate_numbers(field + ".timestep", settings.timestep);
}

inline bool still(const Vector3d& v) { return zero(v.x) && zero(v.y) && zero(v.z); }
inline void validate(const std::string& field, const StepBodyd& body) {
  validate_numbers(field, body), require_inverse_mass(!negative(body.inverse_mass), field + ".inverse_mass");
  require_stillness(!zero(body.inverse_mass) || still(body.velocity), field + ".velocity");
  validate(field + ".sphere", body.sphere);
}
inline void validate(const std::string& field, const StepSettingsd& settings) {
  validate_numbers(field, settings), validate_restitution(field + ".restitution", settings.restitution);
  require_timestep(positive(settings.timestep), field + ".timestep");
}

}  // namespace touchstone::validation
