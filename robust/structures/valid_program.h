// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/validation_of_commands.h"
#include "geometry/validation_of_rays.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

inline void validate_program(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
  validation::validate_program(
      boxes, commands, [](const std::string& field, const auto& shape) { validation::validate_numbers(field, shape); },
      [](const std::string& field, const auto& shape) { validation::validate(field, shape); });
}

}  // namespace touchstone::robust::structures
