// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/closest.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// The point of a valid oriented box that is nearest to a point, the distance and its square, enclosed and rounded;
/// empty if numbers are not `moderate`, or if anything is not certain.
///
/// The guess: each coefficient of a half axis is -1, 1 or free, by the feet of perpendiculars, one half axis after the
/// other. One or two free ones span an edge or a face, of which the foot is the nearest point; with none it is a
/// corner. The proof is that of Karush, Kuhn and Tucker: the free coefficients of the foot are between -1 and 1, and
/// along each other half axis the way from it to the point leads outwards. Then no other point of the box is as near.
Perhaps<ClosestPoint3<double>> closest_in_obb(const Point3d& point, const Obb3d& obb);

/// The contact of a ball and a valid oriented box, by the same proof; empty if the center may be inside.
Perhaps<Contact> close_contact(const Sphere3d& sphere, const Obb3d& obb);

}  // namespace touchstone::robust::kernel
