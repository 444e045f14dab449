// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/obb_of_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/outward.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/integers/term_sum.h"
#include "robust/kernel/shapes/enclosing_ball.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/volumes/point_in_obb.h"

namespace touchstone::robust {
namespace {

using Points = std::vector<Point3d>;
using Axes = std::array<Vector3d, 3>;

/// The least interval [center - reach, center + reach] of doubles around numbers, with the center nearest to their
/// middle; reach > 0. Never beyond the range: the center of the greatest numbers of opposite signs is exact.
struct Interval {
  double center, reach;

  Interval(double low, double high) {
    const auto sum = kernel::exact_sum(std::array{kernel::term(low), kernel::term(high)});
    center = kernel::round_scaled(sum.n, sum.exponent - 1);
    const auto displacement = [](double from, double to) {
      const auto difference = kernel::exact_sum(std::array{kernel::term(to), -kernel::term(from)});
      return kernel::round_up(difference.n, difference.exponent);
    };
    const double above = displacement(center, high), below = displacement(low, center);
    reach = std::max({above, below, std::numeric_limits<double>::denorm_min()});
  }
};

Obb3d straight_box(const Points& points) {
  const auto along = [&points](double Point3d::*axis) {
    double low = points[0].*axis, high = low;
    for (const Point3d& p : points) low = std::min(low, p.*axis), high = std::max(high, p.*axis);
    return Interval(low, high);
  };
  const Interval x = along(&Point3d::x), y = along(&Point3d::y), z = along(&Point3d::z);
  return {{x.center, y.center, z.center}, {{x.reach, 0, 0}, {0, y.reach, 0}, {0, 0, z.reach}}};
}

/// The columns of a matrix that Jacobi's method rotates until the covariance is diagonal.
Axes covariance_axes(const Points& points) {
  const auto count = static_cast<double>(points.size());
  std::array<double, 3> mean{};
  const auto parts = [](const Point3d& p) { return std::array{p.x, p.y, p.z}; };
  for (const Point3d& p : points)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += parts(p)[i] / count;
  std::array<std::array<double, 3>, 3> c{}, turned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const Point3d& p : points)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) c[i][j] += (parts(p)[i] - mean[i]) * (parts(p)[j] - mean[j]);
  constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
  for (std::size_t step = 0; step < 24; ++step) {
    const auto [p, q] = pairs[step % 3];
    if (c[p][q] == 0) continue;
    const double ratio = (c[q][q] - c[p][p]) / (2 * c[p][q]), size = __builtin_fabs(ratio);
    const double steepness = 1 / (size + std::sqrt(ratio * ratio + 1)), tangent = ratio < 0 ? -steepness : steepness;
    const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
    const auto turn = [cosine, sine](double& of_p, double& of_q) {
      const double before = of_p;
      of_p = cosine * before - sine * of_q, of_q = sine * before + cosine * of_q;
    };
    for (auto& row : c) turn(row[p], row[q]);
    for (auto& row : turned) turn(row[p], row[q]);
    for (std::size_t i = 0; i < 3; ++i) turn(c[p][i], c[q][i]);
    c[p][q] = c[q][p] = 0;
  }
  const auto column = [&turned](std::size_t k) { return Vector3d{turned[0][k], turned[1][k], turned[2][k]}; };
  return {column(0), column(1), column(2)};
}

Vector3d of_length_one(const Vector3d& v) {
  const double length = std::sqrt(dot(v, v));
  return {v.x / length, v.y / length, v.z / length};
}

/// The axes orthonormalized again, up to rounding: squared lengths within 24 units of 2^-53 of 1, scalar products
/// within 5 of 0.
Axes right_angled(const Axes& axes) {
  const Vector3d u = of_length_one(axes[0]), w = of_length_one(cross(u, axes[1]));
  return {u, cross(w, u), w};
}

bool holds(const Obb3d& box, const Points& points) {
  return std::all_of(points.begin(), points.end(),
                     [&box](const Point3d& p) { return point_in_obb(box, p) != Location::outside; });
}

/// In doubles; the points are scaled by a power of two, so that their greatest coordinate lies in [1, 2). Along each
/// axis the farthest point from the rounded center is at `reach`, and roundings move it by less than 70 units of 2^-53
/// of the spread: (4 + 24 + 2 . 5 + 2) times the root of 3 (reference/volumes/obb_of_points.h). A box that is longer by
/// as much contains every point, and usually a far shorter one does: the exact test decides. Empty if numbers could be
/// subnormal or beyond the range, and if points are so much nearer to 0 than others that they were lost.
std::optional<Obb3d> turned_box(const Points& points) {
  const double greatest = kernel::greatest_coordinate(points);
  if (greatest == 0) return std::nullopt;
  const int up = -std::ilogb(greatest);
  Points all;
  all.reserve(points.size());
  for (const Point3d& p : points) all.push_back({std::ldexp(p.x, up), std::ldexp(p.y, up), std::ldexp(p.z, up)});
  const Axes axes = right_angled(covariance_axes(all));
  Point3d center{0, 0, 0};
  for (const Vector3d& axis : axes) {
    const auto along = [&axis](const Point3d& p) { return axis.x * p.x + axis.y * p.y + axis.z * p.z; };
    double low = along(all[0]), high = low;
    for (const Point3d& p : all) low = std::min(low, along(p)), high = std::max(high, along(p));
    center = center + (low + high) / 2 * axis;
  }
  std::array<double, 3> reach{};
  double spread = 0;
  for (const Point3d& p : all) {
    const Vector3d displacement = p - center;
    for (std::size_t k = 0; k < 3; ++k) reach[k] = std::max(reach[k], __builtin_fabs(dot(axes[k], displacement)));
    spread = std::max(
        {spread, __builtin_fabs(displacement.x), __builtin_fabs(displacement.y), __builtin_fabs(displacement.z)});
  }
  if (spread == 0 || std::ilogb(spread) - std::max(up, 0) < -900) return std::nullopt;
  const auto unscaled = [up](const auto& v) {  // + 0: of both zeros the positive one
    return std::decay_t<decltype(v)>{std::ldexp(v.x, -up) + 0, std::ldexp(v.y, -up) + 0, std::ldexp(v.z, -up) + 0};
  };
  for (double wider = 0x1p-53; wider <= 0x1p-46; wider *= 2) {
    const auto half = [&](std::size_t k) { return unscaled((reach[k] + wider * spread) * axes[k]); };
    const Obb3d box{unscaled(center), {half(0), half(1), half(2)}};
    if (!kernel::valid(box)) return std::nullopt;
    if (holds(box, points)) return box;
  }
  return std::nullopt;
}

/// Not inlined: a compiler could move its arithmetic to before the control word is set.
[[gnu::noinline]] Obb3d box_around(const Points& points) {
  const std::optional<Obb3d> turned = turned_box(points);
  return turned ? *turned : straight_box(points);
}

}  // namespace

Obb3d obb_of_points(const std::vector<Point3d>& points) {
  const bool valid = std::all_of(points.begin(), points.end(), [](const Point3d& p) { return kernel::valid(p); });
  if (points.empty() || !valid) validation::validate("points", points, rule::points);
  const kernel::ControlWord ieee;
  return box_around(points);
}

}  // namespace touchstone::robust
