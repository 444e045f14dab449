// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/polygon_normal.h"

#include <algorithm>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Vector3<Rational> area_of(const Polygon3<Number>& polygon) {
  validation::validate("polygon", polygon);
  const Point3<Rational> first = exact(polygon[0]);
  Vector3<Rational> sum{0, 0, 0}, previous = exact(polygon[1]) - first;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vector3<Rational> next = exact(polygon[i]) - first, triangle = cross(previous, next);
    sum = {Rational(sum.x + triangle.x), Rational(sum.y + triangle.y), Rational(sum.z + triangle.z)};
    previous = next;
  }
  return sum;
}

Truth<PolygonNormal<Surd>> truth_polygon_normal(const Vector3<Rational>& normal) {
  const Rational squared_length = dot(normal, normal);
  if (sgn(squared_length) == 0)
    return {{NormalClass::degenerate, std::nullopt, std::nullopt}, Rational(0), [] {
              return Certificate{"no_area", {}};
            }};
  const auto part = [&](const Rational& n) { return Surd(0, sgn(n), Rational(n * n / squared_length)); };
  const Rational margin = std::max({Rational(abs(normal.x)), Rational(abs(normal.y)), Rational(abs(normal.z))});
  const Vector3<Surd> sum{normal.x, normal.y, normal.z}, unit{part(normal.x), part(normal.y), part(normal.z)};
  const char* const kind = unit.x.rational() && unit.y.rational() && unit.z.rational() ? "root" : "irrational_root";
  return {{NormalClass::proper, sum, unit}, margin, [kind] { return Certificate{kind, {}}; }};
}

}  // namespace

template <Exact Number>
Truth<PolygonNormal<Surd>> polygon_normal(const Polygon3<Number>& polygon) {
  return truth_polygon_normal(area_of(polygon));
}
template Truth<PolygonNormal<Surd>> polygon_normal(const Polygon3d&);
template Truth<PolygonNormal<Surd>> polygon_normal(const Polygon3<Rational>&);

}  // namespace touchstone::oracle
