// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and a convex polyhedron, as closed solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the ball only reaches the polyhedron, or has
/// the radius 0. The mesh is closed, and its faces are triangles that run counter-clockwise as seen from outside, or
/// all clockwise. Every call checks that it is closed and convex, as point_in_convex_polyhedron does. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do a negative radius ("radius >= 0") and every mesh that is not the surface of a convex solid
/// (with the face). Contract: reference/mixed/sphere_convex.h.
Contact sphere_convex(const Sphere3d& sphere, const Meshd& mesh);

class ConvexSolid;  // robust/prepared/solid.h
/// The same without the mesh's validation.
Contact sphere_convex(const Sphere3d& sphere, const ConvexSolid& solid);

namespace stages {

struct sphere_convex : Signatures<Contact(const Sphere3d&, const Meshd&)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
