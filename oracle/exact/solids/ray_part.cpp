// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/ray_part.h"

#include <algorithm>
#include <utility>

#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

CutRay cut_ray(const Point3<Integer>& origin, const Vector3<Integer>& v, const std::vector<Point3<Integer>>& corners) {
  const Vector3<Integer> to_first = corners[0] - origin;
  Integer ahead(0);
  for (const Point3<Integer>& corner : corners) ahead = std::max(ahead, Integer(dot(v, corner - origin)));
  const Integer length = std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.z))});
  const Integer until(2 + ahead / dot(v, v) + (abs(to_first.x) + abs(to_first.y) + abs(to_first.z)) / length);
  return {{origin, origin + until * v}, until};
}

RayPart::RayPart(CutRay ray, const Triangle3<Integer>& triangle)
    : ray_(std::move(ray)), triangle_(triangle), common_(ray_.segment, triangle) {}

bool RayPart::inside() const {
  const auto& w = common_.first.weights;
  return std::all_of(w.begin(), w.end(), [](const Rational& weight) { return sgn(weight) > 0; }) &&
         !zero(cross(triangle_.b - triangle_.a, triangle_.c - triangle_.a));
}

Rational RayPart::squared_distance_to_touch() const {
  return oracle::squared_distance_to_touch(ray_.segment, triangle_);
}

std::vector<Rational> numbers_of(const WitnessPlane& plane, const std::function<Rational(const Rational&)>& actual) {
  const auto& [x, y, z] = plane.normal;
  return {Rational(x), Rational(y), Rational(z), actual(plane.offset)};
}

Certificate RayPart::of_first(const std::function<Rational(const Rational&)>& actual) const {
  const CommonPoint& first = common_.first;
  std::vector<Rational> before;
  if (sgn(first.t) > 0) before = numbers_of(plane_at_first(ray_.segment, triangle_, first.t), actual);
  return {"common_part",
          {{"on_ray", {on_ray(first)}}, {"weights", {first.weights.begin(), first.weights.end()}}, {"before", before}}};
}

Certificate RayPart::certificate(const std::function<Rational(const Rational&)>& actual) const {
  if (!any())
    return {"separating_plane", {{"plane", numbers_of(between(), actual)}, {"until", {Rational(ray_.until)}}}};
  const CommonPoint& last = common_.last;
  const auto& [a, b] = ray_.segment;
  Certificate found = of_first(actual);
  std::vector<Rational> after;
  if (one()) {
    after = numbers_of(plane_at_first({b, a}, triangle_, Rational(1 - last.t)), actual);
  } else {
    found.facts[0].second.push_back(on_ray(last));
    found.facts[1].second.insert(found.facts[1].second.end(), last.weights.begin(), last.weights.end());
  }
  found.facts.emplace_back("after", after);
  return found;
}

}  // namespace touchstone::oracle
