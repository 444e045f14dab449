// SPDX-License-Identifier: Apache-2.0
#include <touchstone/audit/engines/adapter.h>

using namespace touchstone;

/// The textbook test with four sides, in double.
struct MyEngine {
  static constexpr const char* name = "my engine 1.0";
  static constexpr auto boundary = Boundary::closed;

  static double side(Point2d p, Point2d q, Point2d r) { return cross(q - p, r - p); }
  bool segment_segment(Segment2d a, Segment2d b) {
    return side(a.a, a.b, b.a) * side(a.a, a.b, b.b) <= 0 && side(b.a, b.b, a.a) * side(b.a, b.b, a.b) <= 0;
  }
  Side orientation(Point2d p0, Point2d p1, Point2d p) {
    return side(p0, p1, p) > 0 ? Side::left : side(p0, p1, p) < 0 ? Side::right : Side::on;
  }
};

TOUCHSTONE_ENGINE_MAIN(MyEngine)
