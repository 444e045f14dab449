// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/point_mesh_distance.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// All but location and sign: the first of the nearest points of these faces in lexicographic order, and the first face
/// that has it. They are in ascending order, one at least. Call while a kernel::ControlWord is in scope.
PointMeshDistance<double> nearest_of_faces(const Point3d& point, const Meshd& mesh, std::vector<Index> faces,
                                           Stage& latest);

}  // namespace touchstone::robust::kernel
