// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"
#include "audit/meshes/formats/places.h"

namespace touchstone::audit {

/// The conversion of a mesh of a file into a mesh of the catalogue.
struct Preparation {
  enum class Cut { exact, fan, shortest };
  /// The treatment of faces that are not planar: they are refused, or cut as described for cut_askew
  /// (audit/meshes/askew.h).
  Cut cut = Cut::exact;
  /// Faces that are not planar, but whose thickness (robust::thickness) is at most this, are triangulated like their
  /// projection along an axis. In the file's unit of length.
  std::optional<double> planar;
  /// The vertices to merge (merging_of): 0, those at equal positions; t > 0, those nearer than t times the size.
  std::optional<double> merge;
};

struct PreparedMesh {
  Meshd mesh;
  std::vector<std::size_t> face_in_file;  ///< for each named face its index in MeshFile::faces
  std::vector<std::size_t>
      vertex_in_file;             ///< for each vertex its index in MeshFile::vertices, for merged ones the first
  std::vector<std::string> done;  ///< the changes made, one sentence each
};

/// Planar faces stay polygons; faces that are not planar become triangles if `how` requests it. Merged vertices are
/// removed, and so are corners of a face that are then repeated consecutively, and faces that have fewer than three
/// corners left. Nothing else of the mesh is checked.
///
/// Throws InvalidInput if a face of more than three corners repeats a corner consecutively, has two consecutive corners
/// at the same position, is not planar, or encloses no area without crossing itself. Its field is the position in the
/// file ("notch.obj:17"), its rule begins with the face in the file's numbering and its index in the file's list of
/// faces ("face 3 (mesh.faces[2]): planar: ..."); `field` is the prefix of that list. If several faces break it, the
/// rule states their number.
PreparedMesh prepared(const MeshFile& file, const Preparation& how, const std::string& field = "mesh");

}  // namespace touchstone::audit
