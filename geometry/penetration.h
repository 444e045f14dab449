// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/space.h"
#include "geometry/words.h"

namespace touchstone {

/// True for a mesh of one, two or three vertices and no face. Where an operation takes it, it stands for the hull of
/// these: a triangle, a segment or a point; three that lie on a line are a segment, and those that coincide one point.
template <class Real>
bool is_simplex(const Mesh<Real>& mesh) {
  return named_faces(mesh) == 0 && !mesh.vertices.empty() && mesh.vertices.size() <= 3;
}

/// Both sides of the triangle of its vertices, the last of which is repeated where there are fewer than three.
template <class Real>
std::vector<Face> sides_of_simplex(const Mesh<Real>& mesh) {
  const auto last = static_cast<Index>(mesh.vertices.size() - 1);
  const Index second = last > 0 ? 1 : 0;
  return {{0, second, last}, {0, last, second}};
}

/// The part of a convex solid that lies farthest along a direction: its points on that level are one vertex, an edge or
/// a face.
enum class SolidPart { vertex, edge, face };
constexpr auto words_of(SolidPart) { return as_words("vertex", "edge", "face"); }

/// A part of each of two solids a and b.
struct PartsOfBoth {
  SolidPart a, b;
  static constexpr auto members = as_record("a", "b");
};

/// The least translation of a solid a that leaves it touching a solid b: depth times direction, which has length 1 and
/// points from b to a. The depth is negative if they are disjoint: minus the distance that a has to move towards b.
/// feature: the part of each core that lies farthest against the direction (a) and along it (b).
template <class Real>
struct Penetration {
  Contact contact;
  Real depth;
  Vector3<Real> direction, translation;
  PartsOfBoth feature;
  static constexpr auto members = as_record("contact", "depth", "direction", "translation", "feature");
};

}  // namespace touchstone
