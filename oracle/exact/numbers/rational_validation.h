// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "geometry/rays.h"
#include "geometry/validation.h"
#include "oracle/truth.h"

/// Validation of rationals: the rules of geometry/validation.h, except for finite numbers, which all rationals are.
namespace touchstone::validation {

inline bool zero(const oracle::Rational& value) { return sgn(value) == 0; }
inline bool negative(const oracle::Rational& value) { return sgn(value) < 0; }

/// Every rational is finite.
inline void validate_numbers(const std::string&, const oracle::Rational&) {}
template <template <class> class Shape>
void validate_numbers(const std::string&, const Shape<oracle::Rational>&) {}
template <template <class> class Shape>
void validate_numbers(const std::string&, const std::vector<Shape<oracle::Rational>>&) {}

/// Shapes that are valid if their numbers are. A shape without a rule here does not compile, so that its rules cannot
/// be forgotten.
template <class Shape>
concept AlwaysValid = std::is_same_v<Shape, oracle::Rational> || std::is_same_v<Shape, Point2<oracle::Rational>> ||
    std::is_same_v<Shape, Point3<oracle::Rational>> || std::is_same_v<Shape, Segment2<oracle::Rational>> ||
    std::is_same_v<Shape, Vector3<oracle::Rational>>;
template <AlwaysValid Shape>
void validate(const std::string&, const Shape&) {}

inline void validate(const std::string& field, const Line2<oracle::Rational>& l) {
  if (l.p == l.q) throw InvalidInput(field, "two distinct points");
}
inline void validate_direction(const std::string& field, const Vector2<oracle::Rational>& v) {
  if (zero(v.x) && zero(v.y)) throw InvalidInput(field, "nonzero direction");
}
inline void validate(const std::string& field, const ParametricLine2<oracle::Rational>& l) {
  validate_direction(field + ".direction", l.direction);
}
inline void validate(const std::string& field, const Ray2<oracle::Rational>& r) {
  validate_direction(field + ".direction", r.direction);
}
inline void validate(const std::string& field, const Ray3<oracle::Rational>& r) {
  const auto& [x, y, z] = r.direction;
  if (zero(x) && zero(y) && zero(z)) throw InvalidInput(field + ".direction", "nonzero direction");
}
inline void validate(const std::string& field, const Circle2<oracle::Rational>& c) {
  if (negative(c.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}
inline void validate(const std::string& field, const Plane<oracle::Rational>& plane) {
  const auto& n = plane.normal;
  if (zero(n.x) && zero(n.y) && zero(n.z)) throw InvalidInput(field + ".normal", "nonzero normal");
}
inline void validate(const std::string& field, const Aabb2<oracle::Rational>& box) {
  if (box.min.x > box.max.x) throw InvalidInput(field + ".max[0]", "min <= max");
  if (box.min.y > box.max.y) throw InvalidInput(field + ".max[1]", "min <= max");
}
inline void validate(const std::string& field, const Aabb3<oracle::Rational>& box) {
  if (box.min.x > box.max.x) throw InvalidInput(field + ".max[0]", "min <= max");
  if (box.min.y > box.max.y) throw InvalidInput(field + ".max[1]", "min <= max");
  if (box.min.z > box.max.z) throw InvalidInput(field + ".max[2]", "min <= max");
}
inline void validate(const std::string& field, const Sphere3<oracle::Rational>& ball) {
  if (negative(ball.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}
inline void validate(const std::string& field, const Obb3<oracle::Rational>& box) {
  const auto& [u, v, w] = box.half_axes;
  if (zero(dot(cross(u, v), w))) refuse_dependent(field);
}
inline void validate_normal(const std::string& field, const Vector3<oracle::Rational>& normal) {
  if (zero(normal.x) && zero(normal.y) && zero(normal.z)) throw InvalidInput(field, "nonzero normal");
}
inline void validate(const std::string& field, const Slab<oracle::Rational>& slab) {
  if (slab.min > slab.max) throw InvalidInput(field + "[1]", "min <= max");
}
inline void validate(const std::string& field, const Kdop3<oracle::Rational>& kdop) {
  validate_lengths(field, kdop);
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    validate_normal(field + ".normals[" + std::to_string(i) + "]", kdop.normals[i]);
    validate(field + ".slabs[" + std::to_string(i) + "]", kdop.slabs[i]);
  }
}
template <AlwaysValid Point>
void validate_points(const std::string& field, const std::vector<Point>& points) {
  if (points.empty()) throw InvalidInput(field, "at least 1 point");
}
inline void validate(const std::string& field, const Polygon2<oracle::Rational>& polygon) {
  if (fewer_than_three(polygon.vertices)) throw InvalidInput(field, "at least 3 vertices");
}
inline void validate(const std::string& field, const Polygon3<oracle::Rational>& polygon) {
  if (fewer_than_three(polygon.vertices)) throw InvalidInput(field, "at least 3 vertices");
}
inline void validate(const std::string& field, const Mesh<oracle::Rational>& mesh) { validate_indices(field, mesh); }

}  // namespace touchstone::validation
