// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <string>
#include <utility>
#include <vector>

#include "report/uses.h"

/// Converts the coordinates of an input to pixels, exactly: 5e-324 and 1e308 in one figure neither vanish nor overflow,
/// and two neighbouring doubles are distinct once the view is small enough.
namespace touchstone::report {

struct ExactPoint {
  mpq_class x, y;
};

ExactPoint exact_point(double x, double y);

/// A rectangle of pixels, y downwards.
struct Frame {
  double width = 0, height = 0;
};

struct Pixel {
  double x = 0, y = 0;
};

/// A number of pixels for SVG: at most two decimals.
std::string pixels(double value);

class Viewport {
 public:
  /// All points with a margin. `equal`: one scale for both axes; otherwise each axis has its own if their extents are
  /// far apart, so that a thin input is still visible.
  static Viewport fitted(const std::vector<ExactPoint>& points, const Frame& frame, bool equal);
  /// The points within `half` of `centre` along the shorter side of the frame.
  static Viewport around(const ExactPoint& centre, const mpq_class& half, const Frame& frame);

  const Frame& frame() const { return frame_; }
  /// Pixels as exact numbers; y downwards.
  ExactPoint exactly(const ExactPoint& point) const;
  /// Pixels for drawing; far-away points stay outside, but within the range of a browser's floats.
  Pixel at(const ExactPoint& point) const;
  bool shows(const ExactPoint& point) const;
  mpq_class pixels_per_unit_x() const { return per_x_; }
  mpq_class pixels_per_unit_y() const { return per_y_; }
  ExactPoint corner() const { return {left_, bottom_}; }  ///< coordinates of the lower left corner
  ExactPoint far_corner() const;
  bool stretched() const { return per_x_ != per_y_; }

 private:
  Frame frame_;
  mpq_class left_, bottom_, per_x_, per_y_;
};

/// The part of a + t (b - a), first <= t <= last, that lies within `margin` pixels of the frame; empty if there is
/// none. unbounded: no first (`before`), no last (`beyond`).
struct Stretch {
  bool before = false, beyond = false;
};
std::vector<Pixel> clipped(const Viewport& view, const ExactPoint& a, const ExactPoint& b, const Stretch& stretch,
                           double margin);

/// "3e-16", "0.25": a few significant digits of any rational, however large or small.
std::string about(const mpq_class& value, std::size_t digits = 3);

}  // namespace touchstone::report
