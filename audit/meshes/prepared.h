// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"
#include "audit/meshes/formats/places.h"

namespace touchstone::audit {

/// How a mesh of a file is made a mesh of the catalogue.
struct Preparation {
  enum class Cut { exact, fan, shortest };
  /// What happens to faces that are not planar: they are refused, or cut as cut_askew (audit/meshes/askew.h) says.
  Cut cut = Cut::exact;
  /// Faces that are not planar, but whose thickness (robust::thickness) is at most this, are cut as their projection
  /// along an axis is. In the file's unit of length.
  std::optional<double> planar;
  /// Which vertices become one (merging_of): 0, those in equal positions; t > 0, those nearer than t times the size.
  std::optional<double> merge;
};

struct PreparedMesh {
  Meshd mesh;
  std::vector<std::size_t> face_in_file;  ///< of each named face its place in MeshFile::faces
  std::vector<std::size_t>
      vertex_in_file;             ///< of each vertex its place in MeshFile::vertices, of merged ones the first
  std::vector<std::string> done;  ///< what was done, a sentence each
};

/// Planar faces are the polygons that they are; faces that are not planar become triangles where `how` says so.
/// Vertices that are merged go, and so do corners of a face that are then named twice in a row, and faces that have
/// fewer than three corners left. Nothing else of the mesh is looked at.
///
/// Throws InvalidInput where a face of more than three corners names a corner twice in a row, has two corners in a row
/// in one position, is not planar, or encloses no area without crossing itself. Its field is the place in the file
/// ("notch.obj:17"), its rule begins with the face as the file counts it and its place in the file's list of faces
/// ("face 3 (mesh.faces[2]): planar: ..."); `field` is what that list belongs to. Of several faces the rule says how
/// many break it.
PreparedMesh prepared(const MeshFile& file, const Preparation& how, const std::string& field = "mesh");

}  // namespace touchstone::audit
