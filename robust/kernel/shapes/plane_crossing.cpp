// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/plane_crossing.h"

#include <algorithm>
#include <cstdint>

#include "robust/kernel/integers/rounding.h"

namespace touchstone::robust::kernel {

void to_one_unit(Scaled<mpz_class>& a, Scaled<mpz_class>& b) {
  const int exponent = std::min(a.exponent, b.exponent);
  for (Scaled<mpz_class>* number : {&a, &b}) {
    number->n <<= static_cast<std::uint64_t>(number->exponent - exponent);
    number->exponent = exponent;
  }
}

LinePlaneRelation CrossingLine::relation(bool ends) const {
  const int at_start = sgn(height.n), rise = sgn(climb.n);
  if (rise == 0) return at_start == 0 ? LinePlaneRelation::inside : LinePlaneRelation::none;
  const bool leaves = at_start * rise > 0, falls_short = ends && abs(climb.n) < abs(height.n);
  return leaves || falls_short ? LinePlaneRelation::none : LinePlaneRelation::point;
}

/// t is -height / climb, and the point is (climb from - height way) / climb.
LinePlane<double> CrossingLine::answer(bool ends) const {
  const LinePlaneRelation found = relation(ends);
  if (found != LinePlaneRelation::point) return {found, std::nullopt, std::nullopt};
  const auto coordinate = [this](std::size_t axis) {
    return round_quotient(mpz_class(climb.n * line.at[axis] - height.n * line.at[axis + 3]), climb.n, line.exponent);
  };
  return {found, round_quotient(mpz_class(-height.n), climb.n), Point3d{coordinate(0), coordinate(1), coordinate(2)}};
}

}  // namespace touchstone::robust::kernel
