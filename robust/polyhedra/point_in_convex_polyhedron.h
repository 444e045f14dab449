// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside of a convex polyhedron, on its `boundary` or outside.
///
/// The mesh is closed, and its faces are triangles that run counter-clockwise as seen from outside, or all clockwise.
/// Every call checks that it is closed and convex: the sides of few planes for each edge, or, if these do not tell, the
/// side of each face's plane for each vertex.
/// Right for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does every mesh that is not the surface of a convex solid (with the face).
/// Contract: reference/polyhedra/point_in_convex_polyhedron.h.
Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point);

class ConvexSolid;  // robust/prepared/solid.h
/// The same without its validation, by its tree.
Location point_in_convex_polyhedron(const ConvexSolid& solid, const Point3d& point);

namespace stages {

/// The latest stage that one of its decisions needed.
struct point_in_convex_polyhedron : Signatures<Location(const Meshd&, const Point3d&)> {
  static Staged ask;
  /// The same for a mesh and a point that have been validated; outside: the result of kernel::validate_convex for the
  /// mesh.
  static Decided<Location> of_valid(const Meshd& mesh, const Point3d& point, int outside);
};

}  // namespace stages

}  // namespace touchstone::robust
