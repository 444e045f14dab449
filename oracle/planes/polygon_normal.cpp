// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/polygon_normal.h"

#include <algorithm>
#include <array>

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

std::array<Enclosed, 3> unit_of(const Vector3<Rational>& v, const Rational& squared_length) {
  const auto part = [&](const Rational& n) { return signed_root(Rational(n * n / squared_length), sgn(n)); };
  return {part(v.x), part(v.y), part(v.z)};
}

Truth<PolygonNormal<Rational>> truth(const Vector3<Rational>& normal) {
  const Rational squared_length = dot(normal, normal);
  if (sgn(squared_length) == 0) return {{NormalClass::degenerate, std::nullopt, std::nullopt}, Rational(0)};
  const auto [x, y, z] = unit_of(normal, squared_length);
  const Rational margin = std::max({Rational(abs(normal.x)), Rational(abs(normal.y)), Rational(abs(normal.z))});
  return {{NormalClass::proper, normal, Vector3<Rational>{x.value, y.value, z.value}}, margin};
}

}  // namespace

Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3d& polygon) { return truth(area_of(polygon)); }

template <Exact Number>
Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3<Number>& polygon) {
  return truth(area_of(polygon));
}
template Truth<PolygonNormal<Rational>> polygon_normal(const Polygon3<Rational>&);

Certificate polygon_normal_certificate(const Polygon3d& polygon) {
  const Vector3<Rational> normal = area_of(polygon);
  const Rational squared_length = dot(normal, normal);
  if (sgn(squared_length) == 0) return {"no_area", {}};
  const auto [x, y, z] = unit_of(normal, squared_length);
  if (x.rational() && y.rational() && z.rational()) return {"root", {}};
  return {"enclosure", {{"low", {x.low, y.low, z.low}}, {"high", {x.high, y.high, z.high}}}};
}

}  // namespace touchstone::oracle
