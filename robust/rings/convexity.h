// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/answers.h"
#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The answer of polygon_convexity for a ring of at least three finite vertices, not closed by a repeated one.
Decided<PolygonConvexity> convexity(const Polygon2d& ring);

/// Returns the side of the inside of such a ring if it is convex, and refuses others. `latest` becomes the later one of
/// its value and the last stage that any turn needed.
Side validate_convex(const std::string& field, const Polygon2d& ring, Stage& latest);

}  // namespace touchstone::robust
