// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/repair.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/counted.h"
#include "audit/meshes/findings.h"
#include "audit/meshes/repeated_faces.h"

namespace touchstone::audit {
namespace {

using meshes::Corners;
using Places = std::vector<std::size_t>;

Places in_file(const Places& places, const Places& file) {
  Places result;
  for (const std::size_t i : places) result.push_back(file[i]);
  return result;
}

void drop(std::vector<Corners>& faces, Places& face_in_file, const std::vector<bool>& dropped) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (dropped[i]) continue;
    if (kept != i) faces[kept] = std::move(faces[i]);
    face_in_file[kept++] = face_in_file[i];
  }
  faces.resize(kept), face_in_file.resize(kept);
}

/// Drops the vertices that are merged into others.
void drop_merged(MeshFile& mesh, const std::vector<Index>& into) {
  std::vector<Index> place(mesh.vertices.size());
  std::vector<Point3d> left;
  for (Index v = 0; v < into.size(); ++v) {
    if (into[v] != v) continue;
    place[v] = static_cast<Index>(left.size());
    left.push_back(mesh.vertices[v]);
  }
  mesh.vertices = std::move(left);
  for (Corners& corners : mesh.faces)
    for (Index& v : corners) v = place[v];
}

}  // namespace

Repaired repaired(const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis, const TellStep& tell) {
  Repaired result;
  const auto change = [&](const Places& faces, const char* what) {
    if (!faces.empty())
      result.changes.push_back(
          fmt::format("{} {}: {}", counted(faces.size(), "face"), what, meshes::faces_listed(file, faces)));
  };
  const Merging merging = merging_of(file.vertices, how.merge.value_or(0));
  if (merging.merged > 0) result.changes.push_back(meshes::merging_in_words(merging));
  meshes::ShorterFaces shorter = meshes::shorter_faces(file.faces, merging.into);
  change(shorter.dropped, "dropped with fewer than three corners left");
  change(shorter.shortened, "left without the corners that stood twice in a row");

  MeshFile& mesh = result.mesh;
  mesh.name = file.name, mesh.format = file.format, mesh.vertices = file.vertices,
  mesh.faces = std::move(shorter.faces);
  Places& face_in_file = shorter.face_in_file;
  Places again;
  std::vector<bool> dropped(mesh.faces.size());
  for (const auto& [face, earlier] : meshes::repeated_faces(mesh.faces).same)
    again.push_back(face), dropped[face] = true;
  change(in_file(again, face_in_file), "dropped as repeating an earlier one");
  drop(mesh.faces, face_in_file, dropped);
  drop_merged(mesh, merging.into);

  const Preparation as_merged{how.cut, how.planar, std::nullopt};
  result.left = result.changes.empty() && !how.merge ? diagnosis : diagnosed(mesh, as_merged, tell);
  const Places reversed = result.left.reversed;
  if (reversed.empty()) return result;
  for (const std::size_t i : reversed) std::reverse(mesh.faces[i].begin(), mesh.faces[i].end());
  change(in_file(reversed, face_in_file), "reversed");
  result.left = diagnosed(mesh, as_merged, tell);
  return result;
}

}  // namespace touchstone::audit
