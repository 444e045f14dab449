// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/audit/engines/adapter.h>

/// The textbook test with four sides, in double.
struct MyEngine {
  static constexpr const char* name = "my engine 1.0";
  static constexpr auto boundary = touchstone::Boundary::closed;

  static double side(touchstone::Point2d p, touchstone::Point2d q, touchstone::Point2d r) {
    return cross(q - p, r - p);
  }
  bool segment_segment(touchstone::Segment2d a, touchstone::Segment2d b) {
    return side(a.a, a.b, b.a) * side(a.a, a.b, b.b) <= 0 && side(b.a, b.b, a.a) * side(b.a, b.b, a.b) <= 0;
  }
  touchstone::Side orientation(touchstone::Point2d p0, touchstone::Point2d p1, touchstone::Point2d p) {
    using touchstone::Side;
    return side(p0, p1, p) > 0 ? Side::left : side(p0, p1, p) < 0 ? Side::right : Side::on;
  }
};
