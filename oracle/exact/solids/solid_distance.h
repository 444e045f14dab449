// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/solids/convex_mesh.h"

/// The nearest points of two convex solids without a common point, from the definition: all pairs of a vertex, an edge
/// or a face of each are tried.
namespace touchstone::oracle {

/// A convex mesh in a unit shared with another, its planes positive outside.
struct IntegerSolid {
  std::vector<Point3<Integer>> vertices;
  std::vector<Face> faces;
  std::vector<std::pair<Index, Index>> edges;  // without duplicates
  std::vector<IntegerPlane> planes;

  IntegerSolid(const ConvexMesh& mesh, const std::vector<std::array<Integer, 3>>& at);
  /// A point, or the segment between two: no solid, and without planes.
  explicit IntegerSolid(std::vector<Point3<Integer>> ends);
  Hull hull() const;
  bool holds(const Point3<Rational>& p) const;
  /// Weights of all vertices, for a point of the surface.
  std::vector<Rational> weights(const Point3<Rational>& p) const;
  /// The same for any point of the solid.
  std::vector<Rational> weights_within(const Point3<Rational>& p) const;
};

/// The shortest displacement from a point of b to one of a.
Vector3<Rational> shortest_displacement(const IntegerSolid& a, const IntegerSolid& b);

/// Points of a segment, or of a single point, and of a solid that are nearest to each other: on the segment the first
/// that is behind all planes of the solid, or, if there is none, of the solid moved by the shortest displacement.
NearestPair nearest_pair(const Hull& ends, const ConvexMesh& mesh);

/// Among all points of a that are at the end of that displacement from a point of b, the one nearest to a given point.
Point3<Rational> nearest_to(const Point3<Rational>& point, const IntegerSolid& a, const IntegerSolid& b,
                            const Vector3<Rational>& displacement);
/// The one nearest to a's first vertex.
Point3<Rational> first_nearest(const IntegerSolid& a, const IntegerSolid& b, const Vector3<Rational>& displacement);

/// A vector g with g . (p - on_a) >= 0 for all points p of a, and h . (p - on_b) >= 0 for those of b, h = on_a - a's
/// first point - g: the conditions of Karush, Kuhn and Tucker for on_a. Those of a certificate.
std::vector<Rational> multiplier(const Hull& a, const Hull& b, const Point3<Rational>& on_a,
                                 const Vector3<Rational>& displacement);

}  // namespace touchstone::oracle
