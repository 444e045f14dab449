// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/meshes/diagnosis.h"
#include "audit/meshes/merged.h"
#include "audit/meshes/shorter_faces.h"
#include "audit/meshes/surface.h"
#include "audit/meshes/turning.h"

/// The findings of a diagnosis, each kind in words.
namespace touchstone::audit::meshes {

struct Examined {
  const MeshFile& file;                   ///< as read: all texts use its numbers
  MeshFile mesh;                          ///< with its faces after merging; vertices keep their indices
  std::vector<std::size_t> face_in_file;  ///< of each face of `mesh`
  Surface surface;
};

/// few_faces, and faces that are no polygons.
std::vector<FoundDefect> defects_of_faces(const Examined& examined, const Preparation& how);
/// repeated_face to pinched_vertex.
std::vector<FoundDefect> defects_of_surface(const Examined& examined);
/// flat_face and meeting_faces; `merging_closes` tells whether merging vertices would close open edges.
std::vector<FoundDefect> defects_of_shape(const Examined& examined, const PreparedMesh& cut,
                                          const PolyhedronComplexity<double>& complexity, bool merging_closes);
/// one_sided to filled_cavity.
std::vector<FoundDefect> defects_of_turning(const Examined& examined, const Turning& turning);

/// The beginning of the repair of open edges that merging closes.
inline constexpr const char* merge_them = "merge: ";
/// "face 3 (line 12)", "faces 3 (line 12), 5 (line 14), 6 (line 15) and 4 more"
std::string faces_listed(const MeshFile& file, const std::vector<std::size_t>& faces);
/// "16 of 24 vertices merged into others in equal positions"
std::string merging_in_words(const Merging& merging);

}  // namespace touchstone::audit::meshes
