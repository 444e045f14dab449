// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/polygon_normal.h"

#include <algorithm>
#include <utility>

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/space.h"
#include "oracle/exact/square_root.h"

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

Truth<PolygonNormal<Rational>> truth(const Vector3<Rational>& normal) {
  const Rational squared_length = dot(normal, normal);
  if (sgn(squared_length) == 0)
    return {{NormalClass::degenerate, std::nullopt, std::nullopt}, Rational(0), [] {
              return Certificate{"no_area", {}};
            }};
  const auto part = [&](const Rational& n) { return signed_root(Rational(n * n / squared_length), sgn(n)); };
  Enclosed x = part(normal.x), y = part(normal.y), z = part(normal.z);
  const Rational margin = std::max({Rational(abs(normal.x)), Rational(abs(normal.y)), Rational(abs(normal.z))});
  return {{NormalClass::proper, normal, Vector3<Rational>{x.value, y.value, z.value}},
          margin,
          [x = std::move(x), y = std::move(y), z = std::move(z)]() -> Certificate {
            if (x.rational() && y.rational() && z.rational()) return {"root", {}};
            return {"enclosure", {{"low", {x.low, y.low, z.low}}, {"high", {x.high, y.high, z.high}}}};
          }};
}

}  // namespace

Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3d& polygon) { return truth(area_of(polygon)); }

template <Exact Number>
Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3<Number>& polygon) {
  return truth(area_of(polygon));
}
template Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3<Rational>&);

}  // namespace touchstone::oracle
