// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The defect of a box that is claimed to contain points, at least one, in the words of the contract
/// (reference/volumes/obb_of_points.h); "" if there is none. In integers.
std::string defect_of_box(const std::vector<Point3d>& points, const Obb3<Rational>& box);

}  // namespace touchstone::oracle
