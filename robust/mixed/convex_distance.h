// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Decides whether two convex polyhedra have a common point; if not, returns a pair of nearest points, their distance
/// and its square.
///
/// Touching is `meeting`: both distances are 0, without points. If several pairs are nearest, the one whose point on a
/// is nearest to a.vertices[0]. The meshes are closed, and their faces are triangles that run counter-clockwise as seen
/// from outside, or all clockwise. Every call checks that they are closed and convex, as point_in_convex_polyhedron
/// does. Right for all finite doubles in every floating-point environment, and every number is
/// correctly rounded on its own. NaN and infinities throw InvalidInput, which names the field and "finite number"; so
/// does every mesh that is not the surface of a convex solid (with the face). Contract:
/// reference/mixed/convex_distance.h.
ConvexDistance<double> convex_distance(const Meshd& a, const Meshd& b);

class ConvexSolid;  // robust/prepared/solid.h
/// The same without its validation.
ConvexDistance<double> convex_distance(const ConvexSolid& a, const ConvexSolid& b);

}  // namespace touchstone::robust
