// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/point_mesh_distance.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point of the surface of the solid within a mesh that is nearest to a point, the distance and its square, the
/// distance with a sign (negative inside), the location of the point, and the face, edge or vertex that the nearest
/// point is on.
///
/// The mesh is one that point_in_polyhedron takes. The first of several nearest points in lexicographic order is named,
/// and the least index of the faces that have it. Every call checks that the mesh is closed and sorts its faces into a
/// tree; for many points keep a robust::Solid. Right for all finite doubles in every floating-point environment, and
/// every number correctly rounded on its own (infinite if the exact one is beyond the range). NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so does a mesh that is not closed (with the face and the
/// edge). Contract: reference/polyhedra/point_mesh_distance.h.
PointMeshDistance<double> point_mesh_distance(const Point3d& point, const Meshd& mesh);

class Solid;  // robust/prepared/solid.h
/// The same without its validation, by its tree.
PointMeshDistance<double> point_mesh_distance(const Point3d& point, const Solid& solid);

namespace stages {

/// The latest stage that one of its decisions, or a number, needed.
struct point_mesh_distance : Signatures<PointMeshDistance<double>(const Point3d&, const Meshd&)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
