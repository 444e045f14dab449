// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <vector>

#include "catalogue/families/hard_case.h"
#include "geometry/space.h"

/// Clouds of points in space, drawn from a draw stream: those that are hard for hulls, and for all that is built
/// around points.
namespace touchstone::catalogue {

void cloud_cases(HardCases<std::tuple<std::vector<Point3d>>>& add);

/// Those of more points, which cost more.
void large_cloud_cases(HardCases<std::tuple<std::vector<Point3d>>>& add);

}  // namespace touchstone::catalogue
