// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation_of_capsules.h"
#include "oracle/exact/numbers/rational_validation.h"

namespace touchstone::validation {

inline void validate(const std::string& field, const Capsule3<oracle::Rational>& c) {
  if (negative(c.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}

}  // namespace touchstone::validation
