// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/space_box.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/prepared/validated.h"
#include "robust/structures/face_tree.h"

namespace touchstone::robust {

/// The solid within a closed mesh that is validated once and asked many times, as point_in_polyhedron and
/// polyhedron_polyhedron take it.
///
/// Never changes once it is made, so threads may share it; a copy copies the mesh, and one that was moved from can only
/// be assigned or destroyed. It keeps a tree of the boxes around its faces, about 32 bytes a face: a point costs the
/// faces whose boxes a ray from it meets, about log n where these are few, and at worst all n. Right for all finite
/// doubles in every floating-point environment. The constructors throw InvalidInput, which names `field` and the rule,
/// as the operations do.
class Solid {
 public:
  explicit Solid(Meshd mesh, const std::string& field = "mesh");
  Solid(Validated, Meshd mesh);

  const Meshd& mesh() const { return mesh_; }
  const kernel::SpaceBox& box() const { return box_; }
  const structures::FaceTree& tree() const { return tree_; }

 private:
  Meshd mesh_;
  kernel::SpaceBox box_;
  structures::FaceTree tree_;
};

/// A solid that is convex, as point_in_convex_polyhedron, convex_distance, sphere_convex, capsule_convex, penetration
/// and swept_convex_polyhedra take it. To make it costs the tree and the test for convexity, which each of their calls
/// with a mesh costs.
class ConvexSolid : public Solid {
 public:
  explicit ConvexSolid(Meshd mesh, const std::string& field = "mesh");

  /// The side of the faces' planes on which the outside lies: 1 or -1.
  int outside() const { return surface_.outside; }
  /// True if the surface certainly goes around its inside once.
  bool once() const { return surface_.once; }

 private:
  ConvexSolid(const kernel::ConvexSurface& surface, Meshd&& mesh);

  kernel::ConvexSurface surface_;
};

}  // namespace touchstone::robust
