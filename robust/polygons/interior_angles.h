// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/interior_angles.h. Every angle correctly rounded for all finite doubles, in every
/// floating-point environment. There is one stage: exact products, and an arc tangent on integers until both of its
/// bounds round to the same double (robust/kernel/arc_tangent.h).
std::vector<double> interior_angles(const Polygon2d& polygon);

/// The same, and which stage decided: always Stage::exact.
std::vector<double> interior_angles(const Polygon2d& polygon, Stage& decided);

}  // namespace touchstone::robust
