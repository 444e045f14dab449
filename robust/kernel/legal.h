// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/door.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust::kernel {

/// Whether no number is NaN or infinite. The door itself builds the names of fields, which costs more than the
/// geometry, so it is asked only where this says no; the rules are the door's.
template <class... Doubles>
bool all_finite(Doubles... numbers) {
  return (static_cast<int>(!door::finite(numbers)) + ...) == 0;  // one branch
}
inline bool legal(const Point2d& p) { return all_finite(p.x, p.y); }
inline bool legal(const Segment2d& s) { return all_finite(s.a.x, s.a.y, s.b.x, s.b.y); }
inline bool legal(const Line2d& l) {
  return all_finite(l.p.x, l.p.y, l.q.x, l.q.y) && !(door::same(l.p.x, l.q.x) && door::same(l.p.y, l.q.y));
}
inline bool legal(const Point2d& origin, const Vector2d& direction) {
  return all_finite(origin.x, origin.y, direction.x, direction.y) &&
         !(door::zero(direction.x) && door::zero(direction.y));
}
inline bool legal(const Ray2d& r) { return legal(r.origin, r.direction); }
inline bool legal(const ParametricLine2d& l) { return legal(l.origin, l.direction); }
inline bool legal(const Circle2d& c) { return legal(c.center) && door::finite(c.radius) && !door::negative(c.radius); }

}  // namespace touchstone::robust::kernel
