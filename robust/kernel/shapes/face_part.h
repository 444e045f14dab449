// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/ray_mesh.h"
#include "robust/kernel/shapes/nearest_points.h"

namespace touchstone::robust::kernel {

/// The place of a point of a face in it, by its corners, any number of them.
FacePart face_part(const QuotientPoint& x, const std::vector<IntegerPoint>& corners);

}  // namespace touchstone::robust::kernel
