// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/interior_angles.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/direction.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/rings/simple.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

const int closeness = 60;  // both ends are within 2^-60 units in the last place

/// One double is nearest to all of it, and it is narrow enough.
bool certain(const AngleBetween& angle) {
  const auto bits = [](const Rational& value) { return std::bit_cast<std::uint64_t>(nearest_double(value)); };
  return sgn(angle.low) > 0 && bits(angle.low) == bits(angle.high) &&
         binary_order(Rational(angle.high - angle.low)) < ulp_exponent(angle.high) - closeness;
}

/// MPFR's enclosure, widened by as much again on both sides, so that a few more bits separate the ends from the angle.
AngleBetween enclosed(const Integer& x, const Integer& y) {
  for (int bits = 128;; bits += bits / 2) {
    AngleBetween angle = angle_between(x, y, bits);
    const Rational width(angle.high - angle.low);
    angle.low -= width, angle.high += width;
    if (certain(angle)) return angle;
  }
}

template <class Number>
std::vector<AngleBetween> enclosures(const Polygon2<Number>& polygon) {
  validation::validate("polygon", polygon);
  const IntegerRing r(*validation::OpenRing(polygon));
  if (const auto defect = ring_defect(r)) validation::refuse("polygon", *defect, r.size());
  const int winding = sgn(r.area());
  std::vector<AngleBetween> angles;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const Vector2<Integer> out = r.ring.next(i) - r[i], back = r.ring.previous(i) - r[i];
    const Integer turn(cross(out, back) * winding);
    angles.push_back(enclosed(dot(out, back), turn));
  }
  return angles;
}

Certificate certificate_interior_angles(const std::vector<AngleBetween>& angles) {
  std::vector<Rational> low, high;
  std::int64_t bits = 0;
  for (const AngleBetween& angle : angles) {
    low.push_back(angle.low), high.push_back(angle.high);
    bits = std::max(bits, 32 - binary_order(Rational(angle.high - angle.low)));
  }
  return {"enclosure", {{"low", low}, {"high", high}, {"bits", {Rational(bits)}}}};
}

}  // namespace

template <Exact Number>
Truth<std::vector<Rational>> interior_angles(const Polygon2<Number>& polygon) {
  Truth<std::vector<Rational>> result{{}, Rational(1, 2)};
  std::vector<AngleBetween> angles = enclosures(polygon);
  for (const auto& [low, high] : angles) {
    result.answer.push_back(Rational((low + high) / 2));
    result.margin = std::min(*result.margin, rounding_margin(result.answer.back()));
  }
  result.certificate = [angles = std::move(angles)] { return certificate_interior_angles(angles); };
  return result;
}
template Truth<std::vector<Rational>> interior_angles(const Polygon2d&);
template Truth<std::vector<Rational>> interior_angles(const Polygon2<Rational>&);

}  // namespace touchstone::oracle
