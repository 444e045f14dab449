// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/ray_mesh.h"
#include "geometry/rays.h"
#include "robust/kernel/shapes/triangle_clip.h"

namespace touchstone::robust::kernel {

/// The part of a ray in a triangle, which may have no area, exactly: in integers times 2^exponent. The direction is not
/// 0.
class RayPart {
 public:
  RayPart(const Ray3d& ray, const Triangle3d& triangle);

  SegmentTriangleRelation relation() const;

  /// The first common point, which there is, and its t, rounded.
  double first_t() const;
  Point3d first_point() const;
  /// True if it is on the inner side of all three edges; without area there is no inside.
  bool inside() const;
  bool at_corner() const;

  /// True if it comes before that of another triangle on the same ray.
  friend bool operator<(const RayPart& p, const RayPart& q) { return p.part_.first < q.part_.first; }

 private:
  Point3<mpz_class> origin_;
  Vector3<mpz_class> direction_;
  Triangle3<mpz_class> triangle_;
  int exponent_;
  Clipped part_;
};

/// The place of the first common point of a ray and a triangle, which there is, in a face with these corners that has
/// the triangle as a part.
FacePart first_part_in(const std::vector<Point3d>& corners, const Ray3d& ray, const Triangle3d& triangle);

}  // namespace touchstone::robust::kernel
