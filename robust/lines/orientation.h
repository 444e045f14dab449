// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::robust {

/// Contract: reference/lines/orientation.h. Right for all finite doubles in every floating-point environment.
Side orientation(const Point2d& p0, const Point2d& p1, const Point2d& p);

}  // namespace touchstone::robust
