// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "oracle/exact/solids/triangles.h"
#include "oracle/truth.h"

/// Rays and triangles of space in integers.
namespace touchstone::oracle {

/// A ray, and the segment of it that ends at t = until.
struct CutRay {
  Segment3<Integer> segment;
  Integer until;
};

/// The segment ends where the ray is farther ahead than every corner, and farther from each of them than the origin is
/// from the first; there is at least one.
CutRay cut_ray(const Point3<Integer>& origin, const Vector3<Integer>& direction,
               const std::vector<Point3<Integer>>& corners);

/// The intersection of a ray and a triangle, by the exact linear program over the weights of the cut ray's ends and of
/// the triangle's corners.
class RayPart {
 public:
  RayPart(CutRay ray, const Triangle3<Integer>& triangle);

  bool any() const { return common_.any; }
  /// True if it is one point.
  bool one() const { return common_.first.t == common_.last.t; }
  Rational first_t() const { return on_ray(common_.first); }
  Point3<Rational> first_point() const { return point_at(ray_.segment, common_.first.t); }
  /// True if all three weights of the first point are positive, and the triangle has an area.
  bool inside() const;

  /// For the margin: squared_distance_to_touch of the cut ray.
  Rational squared_distance_to_touch() const;
  /// none: normal . p > offset on the cut ray, < offset on the triangle.
  const WitnessPlane& between() const { return common_.between; }
  /// As in ray_triangle.h, and of the first point alone, which there is; actual(length) is that of a length in units.
  Certificate certificate(const std::function<Rational(const Rational&)>& actual) const;
  Certificate of_first(const std::function<Rational(const Rational&)>& actual) const;

 private:
  Rational on_ray(const CommonPoint& p) const { return Rational(p.t * ray_.until); }

  CutRay ray_;
  Triangle3<Integer> triangle_;
  CommonPart common_;
};

/// The normal and the offset of a plane in the certificate.
std::vector<Rational> numbers_of(const WitnessPlane& plane, const std::function<Rational(const Rational&)>& actual);

}  // namespace touchstone::oracle
