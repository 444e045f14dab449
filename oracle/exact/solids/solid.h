// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// The solid within a closed mesh in integers, times one positive unit, for many queries about points.
///
/// A point is inside if a ray that avoids all edges leaves it through an odd number of faces; all directions are
/// decided by signs of determinants of two corners and the direction, one for each edge, since faces share them.
class Solid {
 public:
  Solid(std::vector<Point3<Integer>> vertices, std::vector<Face> faces, Rational unit);

  const std::vector<Point3<Integer>>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }

  /// Locates a point in units; without a margin. The certificate is in the mesh's units, as in point_in_polyhedron.
  Truth<Location> locate(const Point3<Rational>& p) const;
  /// The same, confirmed by two more rays.
  Truth<Location> locate_by_three_rays(const Point3<Rational>& p) const;
  /// The squared distance of a point from the nearest face, in squares of units.
  Rational squared_distance(const Point3<Rational>& p) const;

 private:
  struct Seen;
  struct Ray;

  template <class Direction>
  Ray missing_all_edges(const Seen& seen, const Direction& direction) const;
  bool along(Ray& ray, const Seen& seen) const;
  Truth<Location> located(const Point3<Rational>& p, bool by_three_rays) const;

  std::vector<Point3<Integer>> vertices_;
  std::vector<Face> faces_;
  Rational unit_;
  std::vector<std::array<Index, 2>> edges_;          ///< lesser vertex first
  std::vector<std::array<std::size_t, 3>> of_face_;  ///< the edges from a to b, b to c, c to a
};

}  // namespace touchstone::oracle
