// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/turning.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robust/structures/solid_mesh.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::audit::meshes {
namespace {

/// The triangles of a sheet over vertices of its own, oriented like its first face.
class PartOfMesh {
 public:
  explicit PartOfMesh(const Meshd& mesh) : mesh_(mesh), place_(mesh.vertices.size()), sheet_(mesh.vertices.size()) {}

  Meshd of(std::size_t sheet, const std::vector<std::pair<Face, bool>>& triangles) {
    Meshd part;
    const auto own = [&](Index v) {
      if (sheet_[v] != sheet + 1) {
        sheet_[v] = sheet + 1, place_[v] = static_cast<Index>(part.vertices.size());
        part.vertices.push_back(mesh_.vertices[v]);
      }
      return place_[v];
    };
    for (const auto& [f, against] : triangles) {
      const Index a = own(f.a), b = own(f.b), c = own(f.c);
      part.faces.push_back(against ? Face{c, b, a} : Face{a, b, c});
    }
    return part;
  }

 private:
  const Meshd& mesh_;
  std::vector<Index> place_;
  std::vector<std::size_t> sheet_;
};

Aabb3d box_of(const Meshd& part) {
  Aabb3d box{part.vertices[0], part.vertices[0]};
  for (const Point3d& p : part.vertices) {
    for (double Point3d::*axis : robust::structures::coordinates) {
      box.min.*axis = std::min(box.min.*axis, p.*axis), box.max.*axis = std::max(box.max.*axis, p.*axis);
    }
  }
  return box;
}

bool holds(const Aabb3d& outer, const Aabb3d& inner) {
  return std::all_of(
      robust::structures::coordinates.begin(), robust::structures::coordinates.end(),
      [&](double Point3d::*axis) { return outer.min.*axis <= inner.min.*axis && inner.max.*axis <= outer.max.*axis; });
}

/// The location of a closed sheet, as far as it is known.
enum class Nested { outside, inside, unknown };

struct Sheets {
  std::vector<std::vector<std::size_t>> faces;
  std::vector<VolumeSign> volume;  ///< with all its faces oriented like its first; none if it surely encloses nothing
  std::vector<Nested> nested;
};

Sheets sheets_of(const Surface& surface, const Meshd* mesh, const std::vector<std::size_t>& face_of,
                 const std::vector<IndexPair>* nesting) {
  const std::size_t count = surface.one_sided.size();
  Sheets sheets{std::vector<std::vector<std::size_t>>(count), std::vector<VolumeSign>(count, VolumeSign::none),
                std::vector<Nested>(count, Nested::outside)};
  for (std::size_t i = 0; i < surface.sheet.size(); ++i) sheets.faces[surface.sheet[i]].push_back(i);
  if (mesh == nullptr) return sheets;
  std::vector<std::vector<std::pair<Face, bool>>> triangles(count);
  const std::vector<Index> named = named_face_of_each(*mesh);
  for (std::size_t k = 0; k < named.size(); ++k)
    triangles[surface.sheet[face_of[named[k]]]].emplace_back(mesh->faces[k], surface.against[face_of[named[k]]]);
  PartOfMesh parts(*mesh);
  std::vector<Aabb3d> boxes;
  std::vector<std::size_t> sheet_of_box;
  for (std::size_t s = 0; s < count; ++s) {
    if (!surface.closed[s] || surface.one_sided[s]) continue;
    const Meshd part = parts.of(s, triangles[s]);
    sheets.volume[s] = robust::structures::sign_of_volume(part);
    boxes.push_back(box_of(part)), sheet_of_box.push_back(s);
  }
  if (nesting == nullptr) {
    for (const auto& [i, j] : robust::structures::swept_pairs(boxes)) {
      if (holds(boxes[i], boxes[j])) sheets.nested[sheet_of_box[j]] = Nested::unknown;
      if (holds(boxes[j], boxes[i])) sheets.nested[sheet_of_box[i]] = Nested::unknown;
    }
    return sheets;
  }
  std::vector<bool> odd(surface.components);
  for (const IndexPair& pair : *nesting) odd[pair.j] = !odd[pair.j];
  for (std::size_t i = 0; i < surface.sheet.size(); ++i)
    if (odd[surface.component[i]]) sheets.nested[surface.sheet[i]] = Nested::inside;
  return sheets;
}

/// For each component the one around it and its siblings: the one that is in no other.
std::vector<std::size_t> outermost(std::size_t components, const std::vector<IndexPair>& nesting) {
  std::vector<bool> held(components);
  for (const IndexPair& pair : nesting) held[pair.j] = true;
  std::vector<std::size_t> result(components);
  for (std::size_t i = 0; i < components; ++i) result[i] = i;
  for (const IndexPair& pair : nesting)
    if (!held[pair.i]) result[pair.j] = pair.i;
  return result;
}

/// Cavities that look outwards while the sheet around them and everything else in it also have the wrong orientation:
/// the inverse of a hollow solid.
void turn_inverses(const Surface& surface, const Sheets& sheets, const std::vector<IndexPair>& nesting,
                   Turning& turning) {
  const std::vector<std::size_t> around = outermost(surface.components, nesting);
  const auto around_face = [&](std::size_t i) { return around[surface.component[i]]; };
  std::vector<std::size_t> wrong(surface.components), all(surface.components);
  for (const auto& faces : sheets.faces) ++all[around_face(faces[0])];
  for (const auto* firsts : {&turning.inside_out, &turning.filled_cavity})
    for (const std::size_t i : *firsts) ++wrong[around_face(i)];
  std::vector<std::size_t> meant;
  for (const std::size_t i : turning.filled_cavity) {
    if (wrong[around_face(i)] < all[around_face(i)]) {
      meant.push_back(i);
      continue;
    }
    turning.inside_out.push_back(i);
    const auto& faces = sheets.faces[surface.sheet[i]];
    turning.outwards.insert(turning.outwards.end(), faces.begin(), faces.end());
  }
  turning.filled_cavity = std::move(meant);
  std::sort(turning.inside_out.begin(), turning.inside_out.end());
}

}  // namespace

Turning turning_of(const Surface& surface, const Meshd* mesh, const std::vector<std::size_t>& face_of,
                   const std::vector<IndexPair>* nesting) {
  const Sheets sheets = sheets_of(surface, mesh, face_of, nesting);
  Turning turning;
  for (std::size_t s = 0; s < sheets.faces.size(); ++s) {
    if (surface.one_sided[s]) continue;
    const std::vector<std::size_t>& faces = sheets.faces[s];
    const auto against = static_cast<std::size_t>(
        std::count_if(faces.begin(), faces.end(), [&](std::size_t i) { return surface.against[i]; }));
    const VolumeSign volume = sheets.volume[s],
                     wanted = sheets.nested[s] == Nested::inside ? VolumeSign::negative : VolumeSign::positive;
    const bool known =
        (volume == VolumeSign::positive || volume == VolumeSign::negative) && sheets.nested[s] != Nested::unknown;
    if (against > 0) {
      const bool turn_against = known ? volume == wanted : 2 * against <= faces.size();
      for (const std::size_t i : faces)
        if (surface.against[i] == turn_against) turning.turned.push_back(i);
    } else if (known && volume != wanted && wanted == VolumeSign::positive) {
      turning.outwards.insert(turning.outwards.end(), faces.begin(), faces.end());
      turning.inside_out.push_back(faces[0]);
    } else if (known && volume != wanted) {
      turning.filled_cavity.push_back(faces[0]);
    }
  }
  if (nesting != nullptr) turn_inverses(surface, sheets, *nesting, turning);
  std::sort(turning.turned.begin(), turning.turned.end()), std::sort(turning.outwards.begin(), turning.outwards.end());
  return turning;
}

}  // namespace touchstone::audit::meshes
