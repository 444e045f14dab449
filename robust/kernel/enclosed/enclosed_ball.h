// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// Balls around points, from enclosures; empty where a sign or a number is not certain. The caller has set IEEE
/// arithmetic (control_word.h).
///
/// Signs and numbers are those of enclosed.h, whose bounds are proved, of `moderate` numbers: polynomials of degree 6
/// in them neither overflow nor underflow. A quotient of two of degree 4 is 0 or at least 2^-464, its error at least
/// 2^-540, and what it leaves at least 2^-954: that times a difference loses digits below 2^-1074, for which the error
/// has room.
namespace touchstone::robust::kernel {

/// A computed squared distance D of two points lies within D 2^-50 + 2^-1070 of the exact one, which is off by five
/// factors between 1 - 2^-53 and 1 + 2^-53 and by three squares that underflow, less than 2^-1074 each. Not proved by
/// machine.
inline double squared_distance(const Point3d& p, const Point3d& q) {
  const Vector3d v = q - p;
  return dot(v, v);
}

/// A ball about the correctly rounded center of an exact ball, certainly within that.
///
/// The rounded center is off by at most 2^-53 of a coordinate, or 2^-1075, on each axis: together by less than twice
/// that of the greatest. The radius is that of the exact ball, correctly rounded, or the root of the computed squared
/// distance from the rounded center to a point on the exact sphere: off by 2^-51 and 2^-53 of itself, and by what the
/// center is off. More than all this is subtracted, twice what the center is off, and 2^-50 from the square: the
/// result, after a few roundings, is the square of the radius of a ball about the rounded center within the exact one.
/// Not proved by machine.
class InnerBall {
 public:
  InnerBall() = default;
  InnerBall(const Point3d& center, double radius) : center_(center) {
    double greatest = 0;
    for (const double x : {center.x, center.y, center.z}) greatest = std::max(greatest, __builtin_fabs(x));
    const double least = radius - (0x1p-50 * (radius + greatest) + 0x1p-1070);
    square_ = least > 0 ? least * least * (1 - 0x1p-50) : 0;
    if (!(square_ <= std::numeric_limits<double>::max())) square_ = 0;  // squares overflow: nothing is certain
  }
  bool holds(const Point3d& p) const { return squared_distance(center_, p) * (1 + 0x1p-49) + 0x1p-1060 <= square_; }

 private:
  Point3d center_{};
  double square_ = 0;
};

/// The least double whose closed ball about the center contains each of these points, up to four.
std::optional<double> enclosed_radius(const Point3d& center, std::span<const Point3d> points);

/// The smallest ball that contains every point, its center correctly rounded, with the least radius about that.
std::optional<Sphere3d> enclosed_smallest_ball(const std::vector<Point3d>& points);

}  // namespace touchstone::robust::kernel
