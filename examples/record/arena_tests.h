// SPDX-License-Identifier: Apache-2.0
#pragma once

#if __has_include(<touchstone/geometry/volumes.h>)
#include <touchstone/geometry/thin_shapes.h>
#include <touchstone/geometry/volumes.h>
#else
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"
#endif

#include <algorithm>
#include <cmath>
#include <utility>

/// The collision tests of the game in arena.cpp, with three bugs.
namespace arena {

using Point = touchstone::Point2<float>;
using Segment = touchstone::Segment2<float>;
using Ball = touchstone::Circle2<float>;
using Crate = touchstone::Aabb2<float>;

inline bool balls_meet(const Ball& a, const Ball& b) {
  const float x = b.center.x - a.center.x, y = b.center.y - a.center.y, reach = a.radius + b.radius;
  const float squared = x * x + y * y;
  if (squared == 0) return false;  // bug: there is no normal, and so there is no contact
  return squared <= reach * reach;
}

inline bool ball_meets_crate(const Ball& ball, const Crate& crate) {
  const float x = ball.center.x - std::clamp(ball.center.x, crate.min.x, crate.max.x);
  const float y = ball.center.y - std::clamp(ball.center.y, crate.min.y, crate.max.y);
  return x * x + y * y <= ball.radius * ball.radius;
}

/// Slabs. Bug: along a side of the crate, 0 times infinity is NaN.
inline bool shot_meets_crate(const Segment& shot, const Crate& crate) {
  float first = 0, last = 1;
  for (float Point::*axis : {&Point::x, &Point::y}) {
    const float inverse = 1 / (shot.b.*axis - shot.a.*axis);
    float enters = (crate.min.*axis - shot.a.*axis) * inverse, leaves = (crate.max.*axis - shot.a.*axis) * inverse;
    if (enters > leaves) std::swap(enters, leaves);
    first = std::max(enters, first);
    last = std::min(leaves, last);
  }
  return first <= last;
}

inline float side(Point p, Point q, Point r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); }

/// Bug: on one line, wherever they are, segments meet.
inline bool steps_meet(const Segment& a, const Segment& b) {
  return side(a.a, a.b, b.a) * side(a.a, a.b, b.b) <= 0 && side(b.a, b.b, a.a) * side(b.a, b.b, a.b) <= 0;
}

}  // namespace arena
