// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/closest_point_on_aabb.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/nearest_in_interval.h"

namespace touchstone::oracle {
namespace {

/// Axis by axis: the point's coordinate, min and max.
template <class Number>
CommonScale<Number, 6> scale_of_closest_point_on_aabb(const Point2<Number>& p, const Aabb2<Number>& box) {
  return CommonScale<Number, 6>({p.x, box.min.x, box.max.x, p.y, box.min.y, box.max.y});
}
template <class Number>
CommonScale<Number, 9> scale_of_closest_point_on_aabb(const Point3<Number>& p, const Aabb3<Number>& box) {
  return CommonScale<Number, 9>({p.x, box.min.x, box.max.x, p.y, box.min.y, box.max.y, p.z, box.min.z, box.max.z});
}

using Nearest = NearestInInterval<Rational>;

/// Refuses invalid input.
template <class Point, class Box>
auto nearest_by_axis(const Point& point, const Box& aabb) {
  const auto n = scale_of_closest_point_on_aabb(point, aabb);
  const auto validate = [&] { validation::validate("point", point), validation::validate("aabb", aabb); };
  if (!n.finite()) validate();
  const auto on_axis = [&](std::size_t k) -> Nearest {
    const Integer p = n.integer(3 * k), min = n.integer(3 * k + 1), max = n.integer(3 * k + 2);
    if (min > max) validate();
    const auto found = nearest_in_interval(p, min, max);
    return {n.actual(rational(found.x), 1), n.actual(rational(found.lower), 1), n.actual(rational(found.upper), 1)};
  };
  std::vector<Nearest> axes{on_axis(0), on_axis(1)};
  if constexpr (requires { point.z; }) axes.push_back(on_axis(2));
  return axes;
}

Certificate multipliers(const std::vector<Nearest>& axes) {
  std::vector<Rational> lower, upper;
  for (const Nearest& axis : axes) lower.push_back(axis.lower), upper.push_back(axis.upper);
  return {"multipliers", {{"lower", std::move(lower)}, {"upper", std::move(upper)}}};
}

}  // namespace

template <Exact Number>
Truth<Point2<Rational>> closest_point_on_aabb(const Point2<Number>& point, const Aabb2<Number>& aabb) {
  auto axes = nearest_by_axis(point, aabb);
  return {{axes[0].x, axes[1].x}, std::nullopt, [axes = std::move(axes)] { return multipliers(axes); }};
}
template <Exact Number>
Truth<Point3<Rational>> closest_point_on_aabb(const Point3<Number>& point, const Aabb3<Number>& aabb) {
  auto axes = nearest_by_axis(point, aabb);
  return {{axes[0].x, axes[1].x, axes[2].x}, std::nullopt, [axes = std::move(axes)] { return multipliers(axes); }};
}
template Truth<Point2<Rational>> closest_point_on_aabb(const Point2d&, const Aabb2d&);
template Truth<Point3<Rational>> closest_point_on_aabb(const Point3d&, const Aabb3d&);
template Truth<Point2<Rational>> closest_point_on_aabb(const Point2<Rational>&, const Aabb2<Rational>&);
template Truth<Point3<Rational>> closest_point_on_aabb(const Point3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
