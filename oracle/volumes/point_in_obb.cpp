// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/point_in_obb.h"

#include <utility>

#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/systems/zonotope.h"

namespace touchstone::oracle {
namespace {

/// The solid around its center, and the displacement from there to the point, in units of the scale.
template <class Number>
struct Question {
  CommonScale<Number, 15> scale;
  Zonotope solid;
  Vector3<Integer> displacement;
};

template <class Number>
Question<Number> validated_point_in_obb(const Obb3<Number>& obb, const Point3<Number>& point) {
  validation::validate_numbers("obb", obb), validation::validate_numbers("point", point);
  validate_parallelepiped("obb", obb);
  const auto& [u, v, w] = obb.half_axes;
  const Point3<Number>& c = obb.center;
  CommonScale<Number, 15> scale(
      {u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, c.x, c.y, c.z, point.x, point.y, point.z});
  const auto at = [&scale](std::size_t i) {
    return Vector3<Integer>{scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
  };
  Zonotope solid({at(0), at(3), at(6)});
  Vector3<Integer> displacement = at(12) - at(9);
  return {std::move(scale), std::move(solid), std::move(displacement)};
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_obb(const Obb3<Number>& obb, const Point3<Number>& point) {
  const Question<Number> q = validated_point_in_obb(obb, point);
  Zonotope::Held held = q.solid.held(q.displacement);
  Zonotope::Support support = q.solid.deciding(q.displacement);
  return {held.growth < 1   ? Location::inside
          : held.growth > 1 ? Location::outside
                            : Location::boundary,
          q.scale.actual(support.squared_distance(), 2),
          [held = std::move(held), n = std::move(support.normal)]() -> Certificate {
            if (held.growth <= 1) return {"coefficients", {{"coefficients", held.coefficients}}};
            return {"separating_plane", {{"normal", {Rational(n.x), Rational(n.y), Rational(n.z)}}}};
          }};
}
template Truth<Location> point_in_obb(const Obb3d&, const Point3d&);
template Truth<Location> point_in_obb(const Obb3<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
