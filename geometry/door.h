// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"

/// The door: what is legal input, once for everybody. Each `admit` throws InvalidInput naming the field and the rule, or
/// returns. Numbers are looked at as bits, so the door holds in every floating-point environment and build type.
namespace touchstone::door {

inline bool finite(double value) { return (std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) != 0x7ff; }

/// -0.0 and 0.0 are zero; a subnormal is not, whatever the control word says.
inline bool zero(double value) { return std::bit_cast<std::uint64_t>(value) << 1 == 0; }
inline bool negative(double value) { return std::bit_cast<std::int64_t>(value) < 0 && !zero(value); }
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (zero(a) && zero(b));
}

inline void admit(const std::string& field, double value) {
  if (!finite(value)) throw InvalidInput(field, "finite number");
}
inline void admit(const std::string& field, const Point2d& p) { admit(field + "[0]", p.x), admit(field + "[1]", p.y); }
inline void admit(const std::string& field, const Vector2d& v) { admit(field + "[0]", v.x), admit(field + "[1]", v.y); }
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

inline void admit(const std::string& field, const Point3d& p) {
  admit(field + "[0]", p.x), admit(field + "[1]", p.y), admit(field + "[2]", p.z);
}
inline void admit(const std::string& field, const Vector3d& v) {
  admit(field + "[0]", v.x), admit(field + "[1]", v.y), admit(field + "[2]", v.z);
}
inline void admit(const std::string& field, const Plane3d& plane) {
  admit(field + ".normal", plane.normal), admit(field + ".offset", plane.offset);
  if (zero(plane.normal.x) && zero(plane.normal.y) && zero(plane.normal.z)) {
    throw InvalidInput(field + ".normal", "nonzero normal");
  }
}

template <class Point>
void admit_ring(const std::string& field, const std::vector<Point>& vertices) {
  if (vertices.size() < 3) throw InvalidInput(field, "at least 3 vertices");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point& p = vertices[i];
    bool legal = finite(p.x) && finite(p.y);
    if constexpr (requires { p.z; }) legal = legal && finite(p.z);
    if (!legal) admit(field + "[" + std::to_string(i) + "]", p);
  }
}
/// Why a ring is not simple: edge `first` has length zero (and `second` is the same), or meets edge `second` > first elsewhere than in a
/// vertex that neighbours share. Edge i goes from vertex i to the next. Of several defects the one with the least `first` counts, edges of
/// length zero before all others, then the least `second`.
struct RingDefect {
  std::size_t first, second;
};

[[noreturn]] inline void refuse(const std::string& field, const RingDefect& defect) {
  const std::string vertex = field + "[" + std::to_string(defect.first) + "]";
  if (defect.first == defect.second) throw InvalidInput(vertex, "different from the next vertex");
  throw InvalidInput(vertex, "simple: its edge must not meet edge " + std::to_string(defect.second));
}

/// Why a polygon is not convex, in this order: an edge of length zero; all vertices on one line; a RingDefect; the first vertex at which
/// the ring turns against its direction.
[[noreturn]] inline void refuse_flat(const std::string& field) {
  throw InvalidInput(field, "convex: vertices on one line have no inside");
}
[[noreturn]] inline void refuse_reflex(const std::string& field, std::size_t vertex) {
  throw InvalidInput(field + "[" + std::to_string(vertex) + "]",
                     "convex: the ring must not turn against its direction");
}

inline void admit(const std::string& field, const Polygon2d& polygon) { admit_ring(field, polygon.vertices); }
inline void admit(const std::string& field, const Polygon3d& polygon) { admit_ring(field, polygon.vertices); }

}  // namespace touchstone::door
