// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "geometry/validation_of_triangles.h"

/// Validation of capsules: see validation.h.
namespace touchstone::validation {

inline void validate_numbers(const std::string& field, const Capsule3d& c) {
  validate_numbers(field + ".segment", c.segment), validate_numbers(field + ".radius", c.radius);
}
inline void validate(const std::string& field, const Capsule3d& c) {
  validate_numbers(field, c);
  if (negative(c.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}

}  // namespace touchstone::validation
