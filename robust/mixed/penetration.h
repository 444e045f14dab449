// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/penetration.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// Decides how deep two cores, each with a radius around it, overlap, and returns the least translation of a that
/// leaves them touching: depth times direction, which has length 1 and points from b to a. A core is a convex
/// polyhedron, or the point, segment or triangle of a mesh of one, two or three vertices and no face: a ball, a
/// capsule, a thick triangle.
///
/// Where they are disjoint the depth is negative, minus their distance, and the translation makes them touch. If
/// several directions are as deep, the one whose farthest vertices of a come first in lexicographic order of their
/// indices, then those of b; where the Minkowski difference of the cores has no inside, the one at a right angle to it
/// whose x, y, z come last in lexicographic order. The meshes are closed, and their faces are triangles that run
/// counter-clockwise as seen from outside, or all clockwise; the radii are not negative. Every call with meshes checks
/// that they are closed and convex. If the interiors certainly meet it asks all vertices once for each face found
/// around the nearest part of the Minkowski difference; if they touch it takes as many steps as there are pairs of
/// edges. Right for all finite doubles in every floating-point environment, and every number is correctly rounded on
/// its own. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does every other mesh
/// that is not the surface of a convex solid (with the face), and a negative radius. Contract:
/// reference/mixed/penetration.h.
Penetration<double> penetration(const Meshd& a, const Meshd& b, double radius_a, double radius_b);

class ConvexSolid;  // robust/prepared/solid.h
/// The same of solids that were checked before.
Penetration<double> penetration(const ConvexSolid& a, const ConvexSolid& b, double radius_a, double radius_b);

}  // namespace touchstone::robust
