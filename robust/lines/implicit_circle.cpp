// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/implicit_circle.h"

#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// n: the center, the radius, the point.
template <class Integer>
Location location(const std::array<Integer, 5>& n) {
  const Integer dx = Integer(n[3] - n[0]), dy = Integer(n[4] - n[1]), r = n[2];
  const kernel::Second<Integer> within = kernel::multiply(r, r) - kernel::multiply(dx, dx) - kernel::multiply(dy, dy);
  const int sign = kernel::sign_of(within);
  return sign > 0 ? Location::inside : sign < 0 ? Location::outside : Location::boundary;
}

void validate_implicit_circle(const Circle2d& circle, const Point2d& point) {
  if (kernel::valid(circle) && kernel::valid(point)) return;
  validation::validate_all("circle", circle, "point", point);
}

}  // namespace

Perhaps<Location> stages::implicit_circle::lattice(const Circle2d& circle, const Point2d& point) {
  const auto lattice = kernel::lattice_of(circle.center.x, circle.center.y, circle.radius, point.x, point.y);
  if (!lattice) return std::nullopt;
  return location(lattice->at);
}

Location stages::implicit_circle::exact(const Circle2d& circle, const Point2d& point) {
  const auto integers = kernel::integers_of(circle.center.x, circle.center.y, circle.radius, point.x, point.y);
  return location(integers.at);
}

Decided<Location> stages::implicit_circle::past_filter(const Circle2d& circle, const Point2d& point) {
  return in_turn<implicit_circle, validate_implicit_circle, Stage::lattice, Stage::exact>(circle, point);
}

}  // namespace touchstone::robust
