// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "audit/counted.h"
#include "audit/meshes/findings.h"
#include "audit/meshes/repeated_faces.h"
#include "geometry/invalid_input.h"

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

/// Triangulates faces that are not planar. Does nothing if another face is not a polygon.
void cut(MeshFile& mesh, Places& face_in_file, const Preparation& how) {
  if (how.cut == Preparation::Cut::exact && !how.planar) return;
  try {
    const PreparedMesh cut = prepared(mesh, how);
    std::vector<Corners> faces;
    for (std::size_t i = 0; i < cut.face_in_file.size(); ++i) faces.push_back(corners_of_named(cut.mesh, i));
    mesh.faces = std::move(faces), face_in_file = in_file(cut.face_in_file, face_in_file);
  } catch (const InvalidInput&) {
  }
}

/// The duplicates.
Places repeated(const Places& ascending) {
  Places twice;
  for (std::size_t i = 1; i < ascending.size(); ++i)
    if (ascending[i] == ascending[i - 1] && (twice.empty() || twice.back() != ascending[i]))
      twice.push_back(ascending[i]);
  return twice;
}

/// Merges only vertices within one closed part, or within the parts that are not closed.
Merging within_parts(const MeshFile& file, const Merging& merging) {
  const meshes::Surface surface(file.faces, file.vertices.size());
  std::vector<bool> open(surface.components);
  for (const meshes::EdgeOfFile& edge : surface.open) open[surface.component[edge.face]] = true;
  std::vector<std::size_t> closed_part(file.vertices.size());  // from 1; 0: none
  for (std::size_t i = 0; i < file.faces.size(); ++i) {
    if (open[surface.component[i]]) continue;
    for (const Index v : file.faces[i]) closed_part[v] = surface.component[i] + 1;
  }
  std::map<std::pair<Index, std::size_t>, Index> first;
  Merging result{merging.into};
  for (Index v = 0; v < merging.into.size(); ++v) {
    result.into[v] = first.try_emplace({merging.into[v], closed_part[v]}, v).first->second;
    if (result.into[v] != v) ++result.merged;
  }
  return result;
}

Repaired repaired_with(const Merging& merging, const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis,
                       const TellStep& tell) {
  Repaired result;
  const auto change = [&](Places faces, const char* what) {
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());  // several triangles of one face that was cut
    if (!faces.empty())
      result.changes.push_back(
          fmt::format("{} {}: {}", counted(faces.size(), "face"), what, meshes::faces_listed(file, faces)));
  };
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
  cut(mesh, face_in_file, {how.cut, how.planar, std::nullopt});
  change(repeated(face_in_file), "cut");

  const bool prepared = how.merge || how.planar || how.cut != Preparation::Cut::exact;
  result.left = result.changes.empty() && !prepared ? diagnosis : diagnosed(mesh, {}, tell);
  const Places reversed = result.left.reversed;
  if (reversed.empty()) return result;
  for (const std::size_t i : reversed) std::reverse(mesh.faces[i].begin(), mesh.faces[i].end());
  change(in_file(reversed, face_in_file), "reversed");
  result.left = diagnosed(mesh, {}, tell);
  return result;
}

}  // namespace

Repaired repaired(const MeshFile& file, const Preparation& how, const Diagnosis& diagnosis, const TellStep& tell) {
  const Merging merging = merging_of(file.vertices, how.merge.value_or(0));
  const Merging apart = how.merge ? merging : within_parts(file, merging);
  Repaired together = repaired_with(merging, file, how, diagnosis, tell);
  if (apart.merged == merging.merged || together.left.solid()) return together;
  return repaired_with(apart, file, how, diagnosis, tell);
}

std::string not_kept(const MeshFile& file) {
  const std::map<std::string, std::string> words{
      {"vt", "texture coordinates"}, {"vn", "normals"}, {"usemtl", "materials"},
      {"mtllib", "materials"},       {"o", "names"},    {"g", "groups"},
      {"s", "smoothing groups"}};
  std::set<std::string> kinds;
  for (const auto& [keyword, count] : file.passed_over) {
    const auto known = words.find(keyword);
    kinds.insert(known == words.end() ? keyword : known->second);
  }
  std::string text;
  for (const std::string& kind : kinds) text += (text.empty() ? "" : ", ") + kind;
  return text;
}

}  // namespace touchstone::audit
