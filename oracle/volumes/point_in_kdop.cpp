// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/point_in_kdop.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {
namespace {

/// The location of the point in one slab.
struct Depth {
  Rational squared;  ///< the distance from the nearer plane, squared, negative beyond it
  Rational value;    ///< N . P
};

/// The least depth over all slabs; refuses invalid input.
template <class Number>
std::vector<Depth> depths(const Kdop3<Number>& kdop, const Point3<Number>& point) {
  validation::validate_all("kdop", kdop, "point", point);
  const IntegerList p = integer_list(std::vector<Number>{point.x, point.y, point.z, Number(1)});
  const Integer &x = p.integers[0], &y = p.integers[1], &z = p.integers[2], &w = p.integers[3];
  std::vector<Depth> found;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const auto& [nx, ny, nz] = kdop.normals[i];
    const IntegerList s = integer_list(std::vector<Number>{nx, ny, nz, kdop.slabs[i].min, kdop.slabs[i].max});
    const Integer &a = s.integers[0], &b = s.integers[1], &c = s.integers[2];
    const Integer height(a * x + b * y + c * z), over(height - s.integers[3] * w), under(s.integers[4] * w - height);
    const Integer depth = std::min(over, under), square(a * a + b * b + c * c);
    Rational squared(Integer(depth * abs(depth)), square);
    squared.canonicalize();
    found.push_back({p.actual(squared, 2), Rational(p.actual(Rational(height), 1) * s.unit)});
  }
  return found;
}

std::size_t deciding_point_in_kdop(const std::vector<Depth>& depths) {
  const auto least = std::min_element(depths.begin(), depths.end(),
                                      [](const Depth& a, const Depth& b) { return a.squared < b.squared; });
  return static_cast<std::size_t>(least - depths.begin());
}

Certificate certificate_point_in_kdop(const std::vector<Depth>& all, std::size_t i) {
  const int sign = sgn(all[i].squared);
  if (sign <= 0)
    return {sign < 0 ? "beyond_slab" : "end_of_slab", {{"slab", {Rational(i)}}, {"value", {all[i].value}}}};
  std::vector<Rational> values;
  for (const Depth& depth : all) values.push_back(depth.value);
  return {"values", {{"values", std::move(values)}}};
}

template <class Number>
Truth<Location> truth_point_in_kdop(const Kdop3<Number>& kdop, const Point3<Number>& point) {
  std::vector<Depth> all = depths(kdop, point);
  const std::size_t i = deciding_point_in_kdop(all);
  const Rational& least = all[i].squared;
  const int sign = sgn(least);
  return {sign < 0   ? Location::outside
          : sign > 0 ? Location::inside
                     : Location::boundary,
          Rational(abs(least)), [all = std::move(all), i] { return certificate_point_in_kdop(all, i); }};
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_kdop(const Kdop3<Number>& kdop, const Point3<Number>& point) {
  return truth_point_in_kdop(kdop, point);
}
template Truth<Location> point_in_kdop(const Kdop3d&, const Point3d&);
template Truth<Location> point_in_kdop(const Kdop3<Rational>&, const Point3<Rational>&);

}  // namespace touchstone::oracle
