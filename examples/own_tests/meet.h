// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone/robust/lines/orientation.h>

#include <algorithm>

/// Do two closed segments have a common point? What a test suite might test: a version with a bug, and without.
namespace my {

using touchstone::Point2d;
using touchstone::Segment2d;
using touchstone::Side;

inline double side(Point2d p, Point2d q, Point2d r) { return cross(q - p, r - p); }

/// The test with four sides as it is often written. Bug: segments on one line "meet" wherever they are; and rounding.
inline bool meet_by_four_sides(Segment2d a, Segment2d b) {
  return side(a.a, a.b, b.a) * side(a.a, a.b, b.b) <= 0 && side(b.a, b.b, a.a) * side(b.a, b.b, a.b) <= 0;
}

/// The same with exact sides, and with the bounding boxes, which also decide for segments on one line.
inline bool meet(Segment2d a, Segment2d b) {
  const auto apart = [](double a1, double a2, double b1, double b2) {
    return std::max(a1, a2) < std::min(b1, b2) || std::max(b1, b2) < std::min(a1, a2);
  };
  const auto all_on_one_side = [](Segment2d s, Segment2d t) {
    const Side first = touchstone::robust::orientation(s.a, s.b, t.a);
    return first != Side::on && first == touchstone::robust::orientation(s.a, s.b, t.b);
  };
  return !apart(a.a.x, a.b.x, b.a.x, b.b.x) && !apart(a.a.y, a.b.y, b.a.y, b.b.y) && !all_on_one_side(a, b) &&
         !all_on_one_side(b, a);
}

}  // namespace my
