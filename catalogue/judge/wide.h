// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/space.h"

namespace touchstone::catalogue {

/// long double has a wider range than double, so that no product of doubles overflows or underflows.
using Displacement = Vector3<long double>;

inline Displacement displacement(const Vector3d& v) { return {v.x, v.y, v.z}; }
inline long double wide_length(const Displacement& v) { return std::sqrt(dot(v, v)); }

}  // namespace touchstone::catalogue
