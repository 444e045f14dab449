// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/polygons.h"
#include "geometry/space.h"
#include "robust/kernel/filters/strict_math.h"

/// Hulls of many points in space. All arithmetic here is IEEE's, rounded to nearest (kernel/control_word.h): the bounds
/// below use that, u = 2^-53 and gradual underflow.
namespace touchstone::robust::hulls {

/// Coordinates for filters: q = (p - origin) * scale on each axis without rounding, so that every determinant keeps its
/// sign and |q| < 2. The origin is 0, or, if all numbers of an axis lie within a factor of two, the end of the interval
/// that is nearer to 0, so that differences from it are exact; the scale is a power of two.
struct Frame {
  std::array<double, 3> origin, scale;
  std::array<double, 3> reach;   ///< |q| <= reach
  std::array<double, 3> centre;  ///< of the points' box, rounded
  int extents;                   ///< the number of axes on which not all numbers are equal

  std::array<double, 3> operator()(const Point3d& p) const {
    return {(p.x - origin[0]) * scale[0], (p.y - origin[1]) * scale[1], (p.z - origin[2]) * scale[2]};
  }

  /// For scales that lose bits of some number: no number is scaled down, and most signs are left to integers.
  void enlarge_only();
};

/// Returns nullopt if a number is not finite. Requires at least one point.
std::optional<Frame> frame_of(const std::vector<Point3d>& points, std::size_t threads = 1);

/// The precision of the numbers in the frame: a power of two that divides all of them.
enum class Grain {
  narrow,  ///< multiples of 2^-15: determinants of four points need no more than 53 bits
  wide,    ///< multiples of 2^-38: determinants need no more than 123 bits
  fine,    ///< neither
  lossy,   ///< scaling lost bits of some number
};

/// For up to `most` points: the cell of each in a cube map around the centre, k * k on each of six faces; its distance
/// from the centre on the axis of that face, and the square of its distance.
struct Directions {
  static constexpr std::size_t most = 256;
  std::array<std::int32_t, most> cell;
  std::array<double, most> distance, squared;
};

/// Fills in the first `count`, and returns the largest power of two that divides all of them.
Grain directions_of(const Point3d* points, std::size_t count, const Frame& frame, int k, Directions& found);

/// Returns the largest power of two that divides the coordinates of all points.
Grain grain_of(const std::vector<Point3d>& points, const Frame& frame);

}  // namespace touchstone::robust::hulls
