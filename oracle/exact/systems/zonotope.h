// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {

/// The points sum r_i e_i with -1 <= r_i <= 1, where three of the edges e_i are linearly independent, in integers. With
/// the half axes of a parallelepiped as edges it is that solid around the origin, with those of two the Minkowski
/// difference of both: the differences of their points, except for the difference of their centers.
///
/// The part of it that lies farthest along a normal n has r_i = 1 or -1, by the sign of n . e_i, for every edge that is
/// not at a right angle to n, and any r_i for the others. It is a facet exactly if two of those others are independent;
/// so the normals of the facets are the cross products of two independent edges.
class Zonotope {
 public:
  explicit Zonotope(std::vector<Vector3<Integer>> edges) : edges_(std::move(edges)) {}

  /// d = sum r_i e_i with -growth <= r_i <= growth, for the least such growth. It is less than 1 exactly where d is
  /// inside, 1 on the boundary, greater outside: the solid is convex and has the origin inside.
  struct Held {
    Rational growth;
    std::vector<Rational> coefficients;
    std::vector<Rational> weights;  ///< of the points of the hull
  };
  /// By linear programming; for the convex hull of points, with the d in it that has the least growth.
  Held held(const Vector3<Integer>& d) const { return held(std::vector<Point3<Integer>>{{d.x, d.y, d.z}}); }
  Held held(const std::vector<Point3<Integer>>& points) const;

  /// The plane of a facet, its normal towards d; height > 0 if d lies beyond it, in units of the normal.
  struct Support {
    Vector3<Integer> normal;
    Integer height;
    Rational squared_distance() const;
  };
  /// Among the planes that d lies beyond the farthest; if it lies beyond none, the nearest of all.
  Support deciding(const Vector3<Integer>& d) const;

 private:
  std::vector<Vector3<Integer>> edges_;
};

/// The determinant is taken in integers: half axes are linearly independent in any unit.
template <class Number>
void validate_parallelepiped(const std::string& field, const Obb3<Number>& box) {
  validation::validate(field, box);
  const auto& [u, v, w] = box.half_axes;
  const CommonScale<Number, 9> n({u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z});
  const auto at = [&n](std::size_t i) { return Vector3<Integer>{n.integer(i), n.integer(i + 1), n.integer(i + 2)}; };
  if (sgn(dot(cross(at(0), at(3)), at(6))) == 0) validation::refuse(field, Obb3d::independent);
}

}  // namespace touchstone::oracle
