// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/triangles.h"

namespace touchstone::oracle {

/// CommonDimension where every coordinate is an integer below 2^13 in size: the planes between the corners that are
/// left come from a finite list instead of a linear program. n . d >= 0 for all differences d of a corner of b and one
/// of a, not always 0, has a solution exactly where an extreme ray of that cone is one, and n is then across two of the
/// d, or where they lie in a plane across one of them in it, or where they lie on a line along it.
int common_dimension_on_grid(const Triangle3<std::int64_t>& a, const Triangle3<std::int64_t>& b);

}  // namespace touchstone::oracle
