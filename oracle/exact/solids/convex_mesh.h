// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polyhedra.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

/// A point in integers times a unit over w > 0.
struct HomogeneousPoint {
  Integer x, y, z, w;
};

/// N . p + offset, positive outside.
struct IntegerPlane {
  Vector3<Integer> normal;
  Integer offset;
  Integer at(const Point3<Integer>& p) const { return Integer(dot(normal, {p.x, p.y, p.z}) + offset); }
  /// Its value times the point's w.
  Integer at(const HomogeneousPoint& p) const { return Integer(dot(normal, {p.x, p.y, p.z}) + offset * p.w); }
};

/// A closed convex mesh in integers times one positive unit, and the plane of every face, in order. Signs and ratios
/// are those of the mesh.
class ConvexMesh {
 public:
  /// Refuses meshes that are not closed and convex, by the rules of reference/polyhedra/point_in_convex_polyhedron.h
  /// and straight from the definition: edges are counted, and every vertex is put into the equation of every face's
  /// plane.
  ConvexMesh(const std::string& field, const Meshd& mesh);
  ConvexMesh(const std::string& field, const Mesh<Rational>& mesh);
  /// The same, or of a simplex (geometry/penetration.h) both sides of its triangle, which has no area where it is less.
  template <class Number>
  static ConvexMesh core(const std::string& field, const Mesh<Number>& mesh);

  /// The point in the unit of the mesh.
  HomogeneousPoint integer(const Point3d& p) const;
  HomogeneousPoint integer(const Point3<Rational>& p) const;

  std::vector<Point3<Integer>> vertices;
  std::vector<Face> faces;
  std::vector<IntegerPlane> planes;
  Rational unit;

 private:
  ConvexMesh(const std::vector<Point3<Rational>>& exactly, const std::vector<Face>& triangles);
  void examine(const std::string& field, const Mesh<Rational>& mesh);
};

}  // namespace touchstone::oracle
