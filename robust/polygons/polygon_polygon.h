// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/polygon_polygon.h. Right for all finite doubles in every floating-point environment.
Contact polygon_polygon(const Polygon2d& a, const Polygon2d& b);

/// The same; `decided` is the latest stage that any turn of three vertices needed.
Contact polygon_polygon(const Polygon2d& a, const Polygon2d& b, Stage& decided);

}  // namespace touchstone::robust
