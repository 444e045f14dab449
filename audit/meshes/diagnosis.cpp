// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/diagnosis.h"

#include <fmt/format.h>

#include <algorithm>

#include "audit/counted.h"
#include "audit/meshes/findings.h"
#include "audit/meshes/turning.h"
#include "geometry/invalid_input.h"
#include "robust/polyhedra/polyhedron_complexity.h"

namespace touchstone::audit {
namespace {

using meshes::Corners;

/// Describes the mesh, as far as indices and positions determine it.
void describe(const meshes::Examined& examined, Diagnosis& diagnosis) {
  const meshes::Surface& surface = examined.surface;
  const MeshFile& mesh = examined.mesh;
  diagnosis.vertices = surface.vertices, diagnosis.edges = surface.edges, diagnosis.faces = mesh.faces.size();
  diagnosis.components = surface.components;
  diagnosis.closed = surface.open.empty(), diagnosis.oriented = surface.turned.empty();
  diagnosis.edge_manifold = surface.crowded.empty();
  diagnosis.vertex_manifold = diagnosis.edge_manifold && surface.pinched.empty();
  bool first = true;
  for (const Corners& corners : mesh.faces) {
    ++diagnosis.faces_by_corners[corners.size()];
    for (const Index v : corners) {
      const Point3d& p = mesh.vertices[v];
      const std::array<double, 3> at{p.x, p.y, p.z};
      if (first) diagnosis.low = diagnosis.high = at, first = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        diagnosis.low[axis] = std::min(diagnosis.low[axis], at[axis]);
        diagnosis.high[axis] = std::max(diagnosis.high[axis], at[axis]);
      }
    }
  }
}

/// The mesh with its vertices merged and the remaining faces.
meshes::Examined examined(const MeshFile& file, const Preparation& how, Diagnosis& diagnosis) {
  MeshFile mesh = file;
  std::vector<std::size_t> face_in_file(file.faces.size());
  for (std::size_t i = 0; i < face_in_file.size(); ++i) face_in_file[i] = i;
  if (how.merge) {
    const Merging merging = merging_of(file.vertices, *how.merge);
    meshes::ShorterFaces shorter = meshes::shorter_faces(file.faces, merging.into);
    diagnosis.done.push_back(meshes::merging_in_words(merging));
    if (!shorter.dropped.empty())
      diagnosis.done.push_back(fmt::format("{} dropped that then had fewer than three corners: {}",
                                           counted(shorter.dropped.size(), "face"),
                                           meshes::faces_listed(file, shorter.dropped)));
    mesh.faces = std::move(shorter.faces), face_in_file = std::move(shorter.face_in_file);
  }
  meshes::Surface surface(mesh.faces, mesh.vertices.size());
  return {file, std::move(mesh), std::move(face_in_file), std::move(surface)};
}

/// Faces that are not planar may cross themselves after they are cut.
std::optional<PreparedMesh> prepared_or_found(const meshes::Examined& mesh, const Preparation& how,
                                              Diagnosis& diagnosis) {
  try {
    PreparedMesh cut = prepared(mesh.mesh, {how.cut, how.planar, std::nullopt});
    diagnosis.done.insert(diagnosis.done.end(), cut.done.begin(), cut.done.end());
    return cut;
  } catch (const InvalidInput& refused) {
    diagnosis.found.push_back({MeshDefect::askew_face, 1, {}, "a face cannot be cut", refused.rule(), "another --cut"});
    return std::nullopt;
  }
}

}  // namespace

Diagnosis diagnosed(const MeshFile& file, const Preparation& how, const TellStep& tell) {
  const auto say = [&tell](const char* step) {
    if (tell) tell(step);
  };
  Diagnosis diagnosis;
  say("connecting faces");
  const meshes::Examined mesh = examined(file, how, diagnosis);
  describe(mesh, diagnosis);
  say("looking at each face");
  diagnosis.found = meshes::defects_of_faces(mesh, how);
  const bool polygons = diagnosis.found.empty();
  std::optional<PreparedMesh> cut;
  std::optional<PolyhedronComplexity<double>> complexity;
  if (polygons && mesh.mesh.faces.size() >= 4) {
    cut = prepared_or_found(mesh, how, diagnosis);
  }
  if (cut) {
    say("looking for faces that meet");
    complexity = robust::polyhedron_complexity(cut->mesh);
    diagnosis.embedded = complexity->embedded, diagnosis.convex = complexity->convex;
    diagnosis.volume = complexity->volume;
    diagnosis.nesting = complexity->nesting.value_or(std::vector<IndexPair>{});
  }
  const auto add = [&diagnosis](std::vector<FoundDefect> more) {
    diagnosis.found.insert(diagnosis.found.end(), std::make_move_iterator(more.begin()),
                           std::make_move_iterator(more.end()));
  };
  add(meshes::defects_of_surface(mesh));
  const bool merging_closes = std::any_of(diagnosis.found.begin(), diagnosis.found.end(), [](const FoundDefect& found) {
    return found.mend.starts_with(meshes::merge_them);
  });
  if (complexity) add(meshes::defects_of_shape(mesh, *cut, *complexity, merging_closes));
  say("turning faces");
  const bool sheets_are_components = mesh.surface.one_sided.size() == mesh.surface.components;
  const meshes::Turning turning =
      turning_of(mesh.surface, cut ? &cut->mesh : nullptr, cut ? cut->face_in_file : std::vector<std::size_t>{},
                 complexity && complexity->nesting && sheets_are_components ? &*complexity->nesting : nullptr);
  add(meshes::defects_of_turning(mesh, turning));
  for (const auto* faces : {&turning.turned, &turning.outwards})
    for (const std::size_t i : *faces) diagnosis.reversed.push_back(mesh.face_in_file[i]);
  std::sort(diagnosis.reversed.begin(), diagnosis.reversed.end());
  std::stable_sort(diagnosis.found.begin(), diagnosis.found.end(),
                   [](const FoundDefect& one, const FoundDefect& other) { return one.defect < other.defect; });
  if (const std::size_t unused = file.vertices.size() - mesh.surface.vertices; unused > 0 && !how.merge)
    diagnosis.notes.push_back(unused == 1 ? "1 vertex is in no face" : counted(unused, "vertex") + " are in no face");
  return diagnosis;
}

}  // namespace touchstone::audit
