// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/triangles.h"
#include "geometry/validation.h"

/// Validation of segments and triangles of space, whose one rule is that their numbers are finite: see validation.h.
namespace touchstone::validation {

inline void validate_numbers(const std::string& field, const Segment3d& s) {
  validate_numbers(field + "[0]", s.a), validate_numbers(field + "[1]", s.b);
}
inline void validate_numbers(const std::string& field, const Triangle3d& t) {
  validate_numbers(field + "[0]", t.a), validate_numbers(field + "[1]", t.b), validate_numbers(field + "[2]", t.c);
}

}  // namespace touchstone::validation
