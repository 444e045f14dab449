// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/space.h"
#include "geometry/volumes.h"

/// Parts of a box that planes cut; rounded, since only drawings use them.
namespace touchstone::catalogue {

/// A half-space: the side of a plane to which its normal points.
using HalfSpace = Plane3d;

/// The half-spaces whose intersection is a box.
std::vector<HalfSpace> half_spaces_of(const Aabb3d& box);

/// The part of a plane that lies in all these half-spaces, of which the first six are those of a box: the corners of a
/// polygon, or none. Also none if a number overflows.
std::vector<Point3d> part_of_plane(const Plane3d& plane, const std::vector<HalfSpace>& half_spaces);

/// The faces of the intersection, each counter-clockwise as seen from outside.
std::vector<std::vector<Point3d>> faces_of_cell(const std::vector<HalfSpace>& half_spaces);

}  // namespace touchstone::catalogue
