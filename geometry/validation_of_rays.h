// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/rays.h"
#include "geometry/validation.h"

namespace touchstone::validation {

inline void validate_numbers(const std::string& field, const Ray3d& r) {
  validate_numbers(field + ".origin", r.origin), validate_numbers(field + ".direction", r.direction);
}
inline void validate(const std::string& field, const Ray3d& r) {
  validate_numbers(field, r);
  const auto& v = r.direction;
  if (zero(v.x) && zero(v.y) && zero(v.z)) throw InvalidInput(field + ".direction", "nonzero direction");
}

}  // namespace touchstone::validation
