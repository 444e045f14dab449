// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/structures/face_tree.h"

namespace touchstone::robust {

/// The faces of a mesh, closed or not, that is validated once and asked many times, as ray_mesh and swept_sphere_mesh
/// take it.
///
/// Never changes once it is made, so threads may share it; a copy copies the mesh, and one that was moved from can only
/// be assigned or destroyed. It keeps a tree of the boxes around its faces, about 32 bytes a face. The constructor
/// throws InvalidInput, which names `field` and the rule, as the operations do.
class Surface {
 public:
  explicit Surface(Meshd mesh, const std::string& field = "mesh");

  const Meshd& mesh() const { return mesh_; }
  /// None without faces.
  const std::optional<structures::FaceTree>& tree() const { return tree_; }

  /// For each triangle the face of which it is a part, where a face has more than three corners; else empty.
  const std::vector<Index>& named() const { return named_; }

  static void validate(const std::string& field, const Meshd& mesh);
  static std::optional<structures::FaceTree> tree_of(const Meshd& mesh);
  static std::vector<Index> named_of(const Meshd& mesh);

 private:
  Meshd mesh_;
  std::vector<Index> named_;
  std::optional<structures::FaceTree> tree_;
};

}  // namespace touchstone::robust
