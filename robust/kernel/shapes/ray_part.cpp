// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/ray_part.h"

#include <cstddef>

#include "robust/kernel/integers/integers.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/face_part.h"

namespace touchstone::robust::kernel {
namespace {

using Point = Point3<mpz_class>;
using Vector = Vector3<mpz_class>;

}  // namespace

RayPart::RayPart(const Ray3d& ray, const Triangle3d& t) {
  const auto& [o, v] = ray;
  const auto integers =
      integers_of(o.x, o.y, o.z, v.x, v.y, v.z, t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z);
  const auto& n = integers.at;
  const auto point = [&n](std::size_t i) { return Point{n[i], n[i + 1], n[i + 2]}; };
  origin_ = point(0), direction_ = {n[3], n[4], n[5]}, triangle_ = {point(6), point(9), point(12)};
  exponent_ = integers.exponent;
  part_ = clipped({origin_, origin_ + direction_}, triangle_, 1, Clipped::ray());
}

SegmentTriangleRelation RayPart::relation() const {
  using Relation = SegmentTriangleRelation;
  if (part_.empty) return Relation::none;
  return part_.first < part_.last ? Relation::segment : Relation::point;
}

double RayPart::first_t() const { return round_quotient(part_.first.numerator, part_.first.denominator); }

Point3d RayPart::first_point() const {
  const mpz_class &n = part_.first.numerator, &d = part_.first.denominator;
  const auto coordinate = [&](const mpz_class& from, const mpz_class& displacement) {
    return round_quotient(mpz_class(d * from + n * displacement), d, exponent_);
  };
  return {coordinate(origin_.x, direction_.x), coordinate(origin_.y, direction_.y),
          coordinate(origin_.z, direction_.z)};
}

bool RayPart::inside() const {
  const auto& [a, b, c] = triangle_;
  const mpz_class &n = part_.first.numerator, &d = part_.first.denominator;
  const Vector normal = cross(b - a, c - a);
  const auto within = [&](const Point& from, const Point& to) {
    const Vector inwards = cross(normal, to - from);
    return d * dot(inwards, origin_ - from) + n * dot(inwards, direction_) > 0;
  };
  return within(a, b) && within(b, c) && within(c, a);
}

bool RayPart::at_corner() const {
  const mpz_class &n = part_.first.numerator, &d = part_.first.denominator;
  const auto at = [&](const Point& corner) {
    const Vector to = corner - origin_;
    return d * to.x == n * direction_.x && d * to.y == n * direction_.y && d * to.z == n * direction_.z;
  };
  return at(triangle_.a) || at(triangle_.b) || at(triangle_.c);
}

FacePart first_part_in(const std::vector<Point3d>& corners, const Ray3d& ray, const Triangle3d& triangle) {
  const auto& [o, v] = ray;
  Polygon3d points{{o, {v.x, v.y, v.z}, triangle.a, triangle.b, triangle.c}};
  points.vertices.insert(points.vertices.end(), corners.begin(), corners.end());
  const auto [at, exponent] = integers_of(points);
  const Vector direction = at[1] - Point{0, 0, 0};
  const auto& [n, d] = clipped({at[0], at[0] + direction}, {at[2], at[3], at[4]}, 1, Clipped::ray()).first;
  const auto coordinate = [&n = n, &d = d](const mpz_class& start, const mpz_class& whole) {
    return mpz_class(d * start + n * whole);
  };
  const Point first{coordinate(at[0].x, direction.x), coordinate(at[0].y, direction.y),
                    coordinate(at[0].z, direction.z)};
  return face_part({first, d}, {at.begin() + 5, at.end()});
}

}  // namespace touchstone::robust::kernel
