// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/point_in_polygon.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/rings/parity.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

using Ring = Polygon2<Integer>;

/// The polygon in integers relative to the point: the point is the origin.
struct Around {
  Ring ring;
  Rational unit;
};

template <class Number>
Around validated_point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  validation::validate_all("polygon", polygon, "point", point);
  Polygon2<Number> all = polygon;
  all.vertices.push_back(point);
  IntegerRing integers(all);
  const Point2<Integer> origin = integers.ring.vertices.back();
  integers.ring.vertices.pop_back();
  for (Point2<Integer>& p : integers.ring.vertices) p = {Integer(p.x - origin.x), Integer(p.y - origin.y)};
  return {std::move(integers.ring), std::move(integers.unit)};
}

template <class Number>
Truth<Location> truth_of_point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  auto [ring, unit] = validated_point_in_polygon(polygon, point);
  return location_by_parity({std::move(ring)}, unit);
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  return truth_of_point_in_polygon(polygon, point);
}
template Truth<Location> point_in_polygon(const Polygon2d&, const Point2d&);
template Truth<Location> point_in_polygon(const Polygon2<Rational>&, const Point2<Rational>&);

Location point_in_polygon_location(const Polygon2d& polygon, const Point2d& point) {
  return location_by_winding<Integer>(validated_point_in_polygon(polygon, point).ring);
}

}  // namespace touchstone::oracle
