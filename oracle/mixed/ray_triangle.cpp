// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/ray_triangle.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/triangles.h"

namespace touchstone::oracle {
namespace {

using Relation = SegmentTriangleRelation;

/// A t beyond which the ray is farther ahead than every corner, and farther from each of them than the origin is from
/// the first.
Integer far_enough(const Point3<Integer>& origin, const Vector3<Integer>& v, const Triangle3<Integer>& t) {
  const Vector3<Integer> to_a = t.a - origin;
  const Integer ahead = std::max({Integer(0), dot(v, to_a), dot(v, t.b - origin), dot(v, t.c - origin)});
  const Integer length = std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.z))});
  return Integer(2 + ahead / dot(v, v) + (abs(to_a.x) + abs(to_a.y) + abs(to_a.z)) / length);
}

template <class Number>
struct Solved {
  using Scale = CommonScale<Number, 15>;

  Solved(const Ray3<Number>& r, const Triangle3<Number>& t)
      : scale({r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z, t.a.x, t.a.y, t.a.z,
               t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}),
        origin(point(0)),
        direction(point(3) - Point3<Integer>{0, 0, 0}),
        triangle{point(6), point(9), point(12)},
        until(far_enough(origin, direction, triangle)),
        segment{origin, origin + until * direction},
        common(segment, triangle) {}

  Point3<Integer> point(std::size_t i) const { return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)}; }
  Point3<Rational> first_point() const {
    const Point3<Rational> p = point_at(segment, common.first.t);
    return {scale.actual(p.x, 1), scale.actual(p.y, 1), scale.actual(p.z, 1)};
  }
  Rational on_ray(const CommonPoint& p) const { return Rational(p.t * until); }
  Location location() const {
    const auto& w = common.first.weights;
    const bool within = std::all_of(w.begin(), w.end(), [](const Rational& weight) { return sgn(weight) > 0; });
    const bool has_area = !zero(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    return within && has_area ? Location::inside : Location::boundary;
  }

  Scale scale;
  Point3<Integer> origin;
  Vector3<Integer> direction;
  Triangle3<Integer> triangle;
  Integer until;
  Segment3<Integer> segment;
  CommonPart common;
};

template <class Number>
Certificate certificate_ray_triangle(const Solved<Number>& s) {
  const auto numbers = [&s](const WitnessPlane& plane) {
    const auto& [x, y, z] = plane.normal;
    return std::vector<Rational>{Rational(x), Rational(y), Rational(z), s.scale.actual(plane.offset, 1)};
  };
  if (!s.common.any)
    return {"separating_plane", {{"plane", numbers(s.common.between)}, {"until", {Rational(s.until)}}}};
  const auto& [first, last] = std::tie(s.common.first, s.common.last);
  std::vector<Rational> on_ray{s.on_ray(first)}, weights(first.weights.begin(), first.weights.end()), before, after;
  if (sgn(first.t) > 0) before = numbers(plane_at_first(s.segment, s.triangle, first.t));
  if (first.t != last.t) {
    on_ray.push_back(s.on_ray(last));
    weights.insert(weights.end(), last.weights.begin(), last.weights.end());
  } else {
    after = numbers(plane_at_first({s.segment.b, s.segment.a}, s.triangle, Rational(1 - last.t)));
  }
  return {"common_part", {{"on_ray", on_ray}, {"weights", weights}, {"before", before}, {"after", after}}};
}

template <class Number>
Truth<RayTriangle<Rational>> truth_of_ray_triangle(const Ray3<Number>& ray, const Triangle3<Number>& triangle) {
  validation::validate_numbers("ray", ray), validation::validate_numbers("triangle", triangle);
  validation::validate("ray", ray);
  Solved<Number> s(ray, triangle);
  Truth<RayTriangle<Rational>> truth{{Relation::none, {}, {}, {}},
                                     s.scale.actual(squared_distance_to_touch(s.segment, s.triangle), 2)};
  if (s.common.any) {
    const bool one = s.common.first.t == s.common.last.t;
    truth.answer = {one ? Relation::point : Relation::segment, s.on_ray(s.common.first), s.first_point(), {}};
    if (one) truth.answer.location = s.location();
  }
  truth.certificate = [s = std::move(s)] { return certificate_ray_triangle(s); };
  return truth;
}

}  // namespace

Truth<RayTriangle<Rational>> ray_triangle(const Ray3d& ray, const Triangle3d& triangle) {
  return truth_of_ray_triangle(ray, triangle);
}

template <Exact Number>
Truth<RayTriangle<Rational>> ray_triangle(const Ray3<Number>& ray, const Triangle3<Number>& triangle) {
  return truth_of_ray_triangle(ray, triangle);
}
template Truth<RayTriangle<Rational>> ray_triangle(const Ray3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
