// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/formats/exact_transform.h"
#include "audit/meshes/formats/mesh_file.h"

namespace touchstone::audit::meshes {

/// What refuses a transform by which a position would be rounded.
inline constexpr const char* exact_transform_rule =
    "a transform that keeps all positions doubles; apply it in the program that exports";

/// A mesh that is put together from parts, each of which may be placed several times.
class Assembly {
 public:
  /// `bytes`: how long the file is. Parts that are placed again and again hold much more, within a limit.
  Assembly(const std::string& name, const std::string& format, std::size_t bytes);

  /// Refuses the file where vertices and corners, with so many more, are beyond the limit.
  void require_room(std::size_t more);
  /// Appends positions, each moved by `transform`; returns the index of the first. `placed_by` is what a refusal names
  /// where one is moved to what is no double ("nodes[3]").
  std::size_t add_vertices(const std::vector<Point3d>& positions, const ExactTransform& transform,
                           const std::string& placed_by);
  /// Appends faces over vertices from `first` on, reversed where the transform mirrors.
  void add_faces(std::vector<std::vector<Index>> faces, std::size_t first, const ExactTransform& transform);

  MeshFile mesh;

 private:
  std::size_t most_, used_ = 0;
};

}  // namespace touchstone::audit::meshes
