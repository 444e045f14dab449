// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedra.h"
#include "oracle/exact/shapes/whole_cloud.h"

namespace touchstone::oracle {

/// For each triangle the later ones of the list whose boxes have a point in common with its own, in ascending order: by
/// a sweep along the x axis.
std::vector<std::vector<Index>> later_triangles_near(const IntegerCloud& cloud, const std::vector<Face>& triangles);

}  // namespace touchstone::oracle
