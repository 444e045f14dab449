// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// Refuses a mesh that is not closed, by the rules of reference/polyhedra/point_in_polyhedron.h, of finite numbers.
void validate_closed(const std::string& field, const Meshd& mesh);

}  // namespace touchstone::robust::kernel
