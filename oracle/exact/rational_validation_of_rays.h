// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation_of_rays.h"
#include "oracle/exact/rational_validation.h"

namespace touchstone::validation {

inline void validate(const std::string& field, const Ray3<oracle::Rational>& r) {
  const auto& v = r.direction;
  if (zero(v.x) && zero(v.y) && zero(v.z)) throw InvalidInput(field + ".direction", "nonzero direction");
}

}  // namespace touchstone::validation
