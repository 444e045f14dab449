// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "geometry/invalid_input.h"
#include "geometry/thin_shapes.h"

/// The door: what is legal input, once for everybody. Each `admit` throws InvalidInput naming the field and the rule, or
/// returns. Numbers are looked at as bits, so the door holds in every floating-point environment and build type.
namespace touchstone::door {

inline bool finite(double value) {
  return (std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) != 0x7ff;
}

/// -0.0 and 0.0 are zero; a subnormal is not, whatever the control word says.
inline bool zero(double value) { return std::bit_cast<std::uint64_t>(value) << 1 == 0; }
inline bool negative(double value) { return std::bit_cast<std::int64_t>(value) < 0 && !zero(value); }
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (zero(a) && zero(b));
}

inline void admit(const std::string& field, double value) {
  if (!finite(value)) throw InvalidInput(field, "finite number");
}
inline void admit(const std::string& field, const Point2d& p) {
  admit(field + "[0]", p.x), admit(field + "[1]", p.y);
}
inline void admit(const std::string& field, const Vector2d& v) {
  admit(field + "[0]", v.x), admit(field + "[1]", v.y);
}
inline void admit(const std::string& field, const Segment2d& s) {
  admit(field + "[0]", s.a), admit(field + "[1]", s.b);
}
inline void admit(const std::string& field, const Line2d& l) {
  admit(field + "[0]", l.p), admit(field + "[1]", l.q);
  if (same(l.p.x, l.q.x) && same(l.p.y, l.q.y)) throw InvalidInput(field, "two distinct points");
}
inline void admit_direction(const std::string& field, const Vector2d& v) {
  admit(field, v);
  if (zero(v.x) && zero(v.y)) throw InvalidInput(field, "nonzero direction");
}
inline void admit(const std::string& field, const ParametricLine2d& l) {
  admit(field + ".origin", l.origin), admit_direction(field + ".direction", l.direction);
}
inline void admit(const std::string& field, const Ray2d& r) {
  admit(field + ".origin", r.origin), admit_direction(field + ".direction", r.direction);
}
inline void admit(const std::string& field, const Circle2d& c) {
  admit(field + ".center", c.center), admit(field + ".radius", c.radius);
  if (negative(c.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}

}  // namespace touchstone::door
