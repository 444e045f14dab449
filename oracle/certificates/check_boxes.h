// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/certificates/check_reading.h"

/// Axis-aligned boxes, of the plane or of space, as claims write them.
namespace touchstone::certify {

/// min[k] <= max[k], two or three of each.
struct Box {
  std::vector<Rational> min, max;
  std::size_t axes() const { return min.size(); }
};

/// Input, by the field's name; `what` is how the field is called in a refusal.
Box box(const json& value, const std::string& what);

}  // namespace touchstone::certify
