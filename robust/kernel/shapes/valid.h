// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// True if no number is NaN or infinite. The full validation builds the names of fields, which costs more than the
/// geometry, so it runs only if this returns false; the rules are those of geometry/validation.h.
template <class... Doubles>
bool all_finite(Doubles... numbers) {
  return (static_cast<int>(!validation::finite(numbers)) + ...) == 0;  // one branch
}
inline bool valid(const Point2d& p) { return all_finite(p.x, p.y); }
inline bool valid(const Segment2d& s) { return all_finite(s.a.x, s.a.y, s.b.x, s.b.y); }
inline bool valid(const Line2d& l) {
  return all_finite(l.p.x, l.p.y, l.q.x, l.q.y) && !(validation::same(l.p.x, l.q.x) && validation::same(l.p.y, l.q.y));
}
inline bool valid(const Point2d& origin, const Vector2d& direction) {
  return all_finite(origin.x, origin.y, direction.x, direction.y) &&
         !(validation::zero(direction.x) && validation::zero(direction.y));
}
inline bool valid(const Ray2d& r) { return valid(r.origin, r.direction); }
inline bool valid(const ParametricLine2d& l) { return valid(l.origin, l.direction); }
inline bool valid(const Circle2d& c) {
  return valid(c.center) && validation::finite(c.radius) && !validation::negative(c.radius);
}

}  // namespace touchstone::robust::kernel
