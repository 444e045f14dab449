// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/aabb_of_points.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "robust/kernel/filters/box_differences.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/filters/processor.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

template <class Point>
struct Of;
template <>
struct Of<Point2d> {
  using Box = Aabb2d;
  static constexpr std::array axes{&Point2d::x, &Point2d::y};
};
template <>
struct Of<Point3d> {
  using Box = Aabb3d;
  static constexpr std::array axes{&Point3d::x, &Point3d::y, &Point3d::z};
};

/// Calls `visit` with every axis; a fold, because g++ leaves a loop over so few as a loop.
template <class Point, class Visit>
[[gnu::always_inline]] inline void for_each_axis(const Visit& visit) {
  std::apply([&](auto... axis) { (visit(axis), ...); }, Of<Point>::axes);
}

/// Returns whether comparisons read a subnormal as 0.
bool subnormals_are_zero() { return !(kernel::processor::at_run_time(0x1p-1074) > 0); }

bool below_normal(double value) { return (std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) == 0; }

/// Turns -0.0 into 0.0, in every rounding mode.
double one_zero(double value) { return validation::zero(value) ? 0.0 : value; }

template <class Point>
typename Of<Point>::Box with_one_zero(typename Of<Point>::Box box) {
  for_each_axis<Point>(
      [&](auto axis) { box.min.*axis = one_zero(box.min.*axis), box.max.*axis = one_zero(box.max.*axis); });
  return box;
}

/// Comparisons of doubles are right in every rounding mode. The sum of all coordinates is finite only if every one is:
/// NaN and infinities persist in a sum; overflow of finite numbers only costs time. If subnormals are read as zero they
/// are equal to each other and to zero, and in order with all other numbers: so an end is right if it is normal.
template <class Point>
Perhaps<typename Of<Point>::Box> filtered(const std::vector<Point>& points) {
  if (points.empty()) return std::nullopt;
  typename Of<Point>::Box box{points[0], points[0]};
  Point sum{};
  for (const Point& p : points) {
    for_each_axis<Point>([&](auto axis) {
      box.min.*axis = kernel::lesser(p.*axis, box.min.*axis), box.max.*axis = kernel::greater(p.*axis, box.max.*axis);
      sum.*axis += p.*axis;
    });
  }
  if (!kernel::valid(sum)) return std::nullopt;
  int below = 0;
  for_each_axis<Point>([&](auto axis) {
    below |= static_cast<int>(below_normal(box.min.*axis)) | static_cast<int>(below_normal(box.max.*axis));
  });
  if (below == 0) return box;
  if (subnormals_are_zero()) return std::nullopt;
  return with_one_zero<Point>(box);
}

template <class Point>
typename Of<Point>::Box exactly(const std::vector<Point>& points) {
  typename Of<Point>::Box box{points[0], points[0]};
  for (const Point& p : points) {
    for_each_axis<Point>([&](auto axis) {
      if (kernel::ordered_bits(p.*axis) < kernel::ordered_bits(box.min.*axis)) box.min.*axis = p.*axis;
      if (kernel::ordered_bits(p.*axis) > kernel::ordered_bits(box.max.*axis)) box.max.*axis = p.*axis;
    });
  }
  return with_one_zero<Point>(box);
}

template <class Point>
void validate_aabb_of_points(const std::vector<Point>& points) {
  const bool valid = std::all_of(points.begin(), points.end(), [](const Point& p) { return kernel::valid(p); });
  if (!valid || points.empty()) validation::validate("points", points, rule::points);
}

template <class Point>
typename Of<Point>::Box answer(const std::vector<Point>& points) {
  if (const auto box = filtered(points)) return *box;
  validate_aabb_of_points(points);
  return exactly(points);
}

template <class Point>
Perhaps<stages::aabb_of_points::Box> either(const Perhaps<Point>& box) {
  if (!box) return std::nullopt;
  return stages::aabb_of_points::Box(*box);
}

}  // namespace

using Box = stages::aabb_of_points::Box;
Perhaps<Box> stages::aabb_of_points::filter(const std::vector<Point2d>& points) { return either(filtered(points)); }
Perhaps<Box> stages::aabb_of_points::filter(const std::vector<Point3d>& points) { return either(filtered(points)); }
Box stages::aabb_of_points::exact(const std::vector<Point2d>& points) { return exactly(points); }
Box stages::aabb_of_points::exact(const std::vector<Point3d>& points) { return exactly(points); }
Decided<Box> stages::aabb_of_points::ask(const std::vector<Point2d>& points) {
  return in_turn<aabb_of_points, Stage::filter, validate_aabb_of_points<Point2d>, Stage::exact>(points);
}
Decided<Box> stages::aabb_of_points::ask(const std::vector<Point3d>& points) {
  return in_turn<aabb_of_points, Stage::filter, validate_aabb_of_points<Point3d>, Stage::exact>(points);
}

Aabb2d aabb_of_points(const std::vector<Point2d>& points) { return answer(points); }
Aabb3d aabb_of_points(const std::vector<Point3d>& points) { return answer(points); }

}  // namespace touchstone::robust
