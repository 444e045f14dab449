// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polygons.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

/// The points p with normal . p = level; all points lie behind it: its normal points to the outside.
struct SupportingPlane {
  Vector3<Integer> normal;
  Integer level;
};

/// Points of space in integers times one positive unit.
class IntegerCloud {
 public:
  explicit IntegerCloud(const std::vector<Point3d>& points);
  explicit IntegerCloud(const std::vector<Point3<Rational>>& points);

  Index size() const { return static_cast<Index>(points.size()); }
  const Point3<Integer>& operator[](Index i) const { return points[i]; }
  Vector3<Integer> between(Index from, Index to) const { return points[to] - points[from]; }
  Vector3<Integer> normal(Index a, Index b, Index c) const { return cross(between(a, b), between(a, c)); }
  /// Positive if p lies on the side of the normal.
  Integer height(const SupportingPlane& plane, Index p) const { return Integer(along(plane.normal, p) - plane.level); }
  Integer along(const Vector3<Integer>& v, Index p) const {
    return Integer(v.x * points[p].x + v.y * points[p].y + v.z * points[p].z);
  }
  SupportingPlane plane(const Vector3<Integer>& normal, Index at) const { return {normal, along(normal, at)}; }
  /// The lexicographically least, and of equal ones the first.
  Index least() const;
  /// As few points as possible that span all others, the least first; four are only counted.
  std::vector<Index> simplex() const;

  std::vector<Point3<Integer>> points;
  Rational unit;
};

/// The lexicographic order.
bool before(const Point3<Integer>& p, const Point3<Integer>& q);

/// 1 if three points in a plane turn left about its normal, -1 to the right.
int turn_in(const IntegerCloud& cloud, const SupportingPlane& plane, Index a, Index b, Index c);

/// The extreme points of the points in a plane that has at least three not collinear, counter-clockwise about its
/// normal from the least index. Equal points are represented by the first.
std::vector<Index> ring_in(const IntegerCloud& cloud, const SupportingPlane& plane);

/// Both ends of collinear points, if not all are equal: the lexicographically least first.
std::vector<Index> ends_of(const IntegerCloud& cloud);

/// The faces of the hull of points that are not coplanar, each like the result of ring_in.
std::vector<std::vector<Index>> face_rings(const IntegerCloud& cloud);

}  // namespace touchstone::oracle
