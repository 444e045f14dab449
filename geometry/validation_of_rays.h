// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/validation_of_triangles.h"

/// Validation of rays of space: see validation.h.
namespace touchstone::validation {

inline void validate_numbers(const std::string& field, const Ray3d& ray) {
  validate_numbers(field + ".origin", ray.origin), validate_numbers(field + ".direction", ray.direction);
}

inline void validate(const std::string& field, const Ray3d& ray) {
  validate_numbers(field, ray);
  const auto& [x, y, z] = ray.direction;
  if (zero(x) && zero(y) && zero(z)) throw InvalidInput(field + ".direction", "nonzero direction");
}

}  // namespace touchstone::validation
