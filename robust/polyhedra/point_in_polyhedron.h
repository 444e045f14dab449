// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

namespace structures {
class FaceTree;
}

/// Decides whether a point lies inside of the solid within a mesh, on its `boundary`, which is all of its faces, or
/// outside.
///
/// The mesh is closed: every edge, an unordered pair of vertices, is in an even number of faces. It may be concave,
/// have several parts, one within another, cross itself, have duplicate faces or faces without area, and faces may have
/// either orientation: a point is inside if a ray leaves it through an odd number of faces. Every call checks that the
/// mesh is closed, by sorting its edges; then it tests each face once. Right for all finite doubles in every
/// floating-point environment. NaN and infinities throw InvalidInput, which names the field and "finite number"; so
/// does a mesh that is not closed (with the face and the edge). Contract: reference/polyhedra/point_in_polyhedron.h.
Location point_in_polyhedron(const Meshd& mesh, const Point3d& point);

class Solid;  // robust/prepared/solid.h
/// The same without its validation, by its tree.
Location point_in_polyhedron(const Solid& solid, const Point3d& point);

/// Each stage alone, for tests and other operations; not part of the API.
namespace stages {

/// The latest stage that one of its decisions needed.
struct point_in_polyhedron : Signatures<Location(const Meshd&, const Point3d&)> {
  static Staged ask;
  static Staged of_valid;  ///< the same for a mesh and a point that have been validated
  /// The same by a tree of all faces.
  static Decided<Location> of_tree(const Meshd& mesh, const structures::FaceTree& tree, const Point3d& point);
  /// The same for some faces; the others do not meet the ray to +x.
  static Decided<Location> of_faces(const Meshd& mesh, const std::vector<Index>& faces, const Point3d& point);
};

}  // namespace stages

}  // namespace touchstone::robust
