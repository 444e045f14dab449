// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/ray_mesh.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

/// The place of a point of a face in it, by its corners, any number of them.
FacePart face_part(const std::vector<Point3<Rational>>& corners, const Point3<Rational>& x);

}  // namespace touchstone::oracle
