// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "geometry/rays.h"
#include "geometry/triangles.h"

/// Answers about meshes, and rays or moving solids.
namespace touchstone {

/// The place of a point in a face. All of a face without area is its edges and vertices.
enum class FacePart { inside, edge, vertex };
constexpr auto words_of(FacePart) { return as_words("inside", "edge", "vertex"); }

/// A common point of a ray and a face, its t, the face's index, and the place of the point in the face.
template <class Real>
struct FaceHit {
  Real t;
  Point3<Real> point;
  Index face;
  FacePart part;
  static constexpr auto members = as_record("t", "point", "face", "part");
};

/// relation `hit`: the first common point of a ray and the faces of a mesh, in the face with the least index of those
/// that have it; and how many faces the ray meets. `none`: it meets none.
template <class Real>
struct RayMesh {
  PassageRelation relation;
  std::optional<FaceHit<Real>> first;
  Index faces_met;
  static constexpr auto members = as_record("relation", "first", "faces_met");
};

/// relation `hit`: the first t in [0, 1] at which a moving solid has a common point with a mesh, and the least index of
/// the faces with which it has one then. `never`: neither.
template <class Real>
struct FirstFaceContact {
  HitRelation relation;
  std::optional<Real> t;
  std::optional<Index> face;
  static constexpr auto members = as_record("relation", "t", "face");
};

/// A face as a triangle.
template <class Real>
Triangle3<Real> triangle_of_face(const Mesh<Real>& mesh, std::size_t face) {
  const auto& [a, b, c] = mesh.faces[face];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

}  // namespace touchstone
