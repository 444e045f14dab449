// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/bounding_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/enclosing_ball.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using Points = std::vector<Point3d>;
using Coordinate = double Point3d::*;

struct Ends {
  std::size_t low, high;
};
/// The first points with the least and with the greatest coordinate.
Ends ends_along(Coordinate axis, const Points& points) {
  Ends ends{0, 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].*axis < points[ends.low].*axis) ends.low = i;
    if (points[i].*axis > points[ends.high].*axis) ends.high = i;
  }
  return ends;
}

template <class OnAxis>
Point3d by_axis(const OnAxis& on_axis) {
  return {on_axis(&Point3d::x), on_axis(&Point3d::y), on_axis(&Point3d::z)};
}

double middle(double p, double q) {
  const auto sum = kernel::exact_sum(std::array{kernel::term(p), kernel::term(q)});
  return kernel::round_scaled(sum.n, sum.exponent - 1);
}
Point3d center_of_box(const Points& points) {
  return by_axis([&points](Coordinate axis) {
    const Ends ends = ends_along(axis, points);
    return middle(points[ends.low].*axis, points[ends.high].*axis);
  });
}

Point3d centroid(const Points& points) {
  return by_axis([&points](Coordinate axis) {
    kernel::Scaled<mpz_class> sum{0, 0};
    for (const Point3d& p : points) {
      const kernel::Term term = kernel::term(p.*axis);
      if (term.magnitude == 0) continue;
      const int lower = sum.exponent - term.exponent;
      if (lower > 0) sum.n <<= static_cast<std::uint64_t>(lower), sum.exponent = term.exponent;
      sum.n += kernel::scaled(term, term.exponent - sum.exponent);
    }
    return kernel::round_quotient(sum.n, mpz_class(static_cast<std::uint64_t>(points.size())), sum.exponent);
  });
}

/// Ritter's ball in doubles, its points scaled by a power of two so that the greatest coordinate lies in [1, 2):
/// nothing overflows, and underflow is far below the last place of that. The proof of 3/2 in the contract tolerates
/// errors: rounding moves the center of a step, and with it the radius, by less than two units in the last place of
/// that coordinate and of the radius, and no later step increases the error of an earlier one.
Point3d center_of_growing_ball(const Points& points) {
  const double greatest = kernel::greatest_coordinate(points);
  if (greatest == 0) return {0, 0, 0};
  const int up = -std::ilogb(greatest);
  Points all;
  all.reserve(points.size());
  for (const Point3d& p : points) all.push_back(by_axis([&](Coordinate axis) { return std::ldexp(p.*axis, up); }));
  const auto squared_distance = [](const Point3d& p, const Point3d& q) {
    const Vector3d v = q - p;
    return dot(v, v);
  };
  Ends widest{0, 0};
  double width = 0;
  for (const Coordinate axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
    const Ends ends = ends_along(axis, all);
    const double square = squared_distance(all[ends.low], all[ends.high]);
    if (square > width) widest = ends, width = square;
  }
  const Point3d &a = all[widest.low], &b = all[widest.high];
  Point3d center{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  double radius = std::sqrt(width) / 2;
  for (const Point3d& p : all) {
    const double distance = std::sqrt(squared_distance(center, p));
    if (!(distance > radius)) continue;
    const double larger = (radius + distance) / 2, t = (distance - larger) / distance;
    center = by_axis([&](Coordinate axis) { return center.*axis + t * (p.*axis - center.*axis); });
    radius = larger;
  }
  return by_axis([&](Coordinate axis) { return std::ldexp(center.*axis, -up); });
}

/// Not inlined: a compiler could move its arithmetic to before the control word is set.
[[gnu::noinline]] Sphere3d ball_of(const Points& points, SphereMethod method) {
  const auto about = [&points](const Point3d& center) {
    return Sphere3d{center, kernel::least_radius(center, points)};
  };
  switch (method) {
    case SphereMethod::box: return about(center_of_box(points));
    case SphereMethod::centroid: return about(centroid(points));
    case SphereMethod::ritter: return about(center_of_growing_ball(points));
    case SphereMethod::smallest: break;
  }
  return kernel::smallest_ball(points);
}

}  // namespace

Sphere3d bounding_sphere(const std::vector<Point3d>& points, SphereMethod method) {
  const bool valid = std::all_of(points.begin(), points.end(), [](const Point3d& p) { return kernel::valid(p); });
  if (points.empty() || !valid) validation::validate("points", points, rule::points);
  const kernel::ControlWord ieee;
  return ball_of(points, method);
}

}  // namespace touchstone::robust
