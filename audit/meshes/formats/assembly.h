// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/formats/exact_transform.h"
#include "audit/meshes/formats/mesh_file.h"

namespace touchstone::audit::meshes {

/// The rule that refuses a transform that would round a position.
inline constexpr const char* exact_transform_rule =
    "a transform that keeps all positions doubles; apply it in the program that exports";

/// A mesh assembled from parts, each of which may be placed several times.
class Assembly {
 public:
  /// `bytes`: the length of the file. Parts that are placed repeatedly hold much more, within a limit.
  Assembly(const std::string& name, const std::string& format, std::size_t bytes);

  /// Refuses the file if this many more vertices and corners would exceed the limit.
  void require_room(std::size_t more);
  /// Appends positions, each moved by `transform`; returns the index of the first. `placed_by` is named in the refusal
  /// if an image is not a double ("nodes[3]").
  std::size_t add_vertices(const std::vector<Point3d>& positions, const ExactTransform& transform,
                           const std::string& placed_by);
  /// Appends faces over vertices from `first` on, reversed if the transform mirrors.
  void add_faces(std::vector<std::vector<Index>> faces, std::size_t first, const ExactTransform& transform);

  MeshFile mesh;

 private:
  std::size_t most_, used_ = 0;
};

}  // namespace touchstone::audit::meshes
