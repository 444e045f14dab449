// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "proptests/response_laws.h"

/// Laws of turning bodies.
namespace touchstone::proptests {

/// The same body with another velocity.
template <class Body, class R>
Body with_velocity(Body body, const Vector3<R>& velocity) {
  body.velocity = velocity;
  return body;
}
/// Its turn times a number.
template <class Body, class R>
Body with_turn(Body body, const R& factor) {
  body.angular_velocity = factor * body.angular_velocity;
  return body;
}

/// Whether a right hand becomes a left one.
inline bool turns_over(const AxisMap& map) {
  const bool cyclic = map.from[1] == (map.from[0] + 1) % 3;
  return (map.sign[0] * map.sign[1] * map.sign[2] < 0) == cyclic;
}

inline Motion3 from_origin(const Point3<Rational>& p) { return {p.x, p.y, p.z}; }

/// As one sees a body who moves and turns himself: every point has the velocity s + t x point more.
template <class Body>
Body as_seen(Body body) {
  const Motion3 s{Rational(7, 3), Rational(-11), Rational(13, 5)}, t{Rational(-3), Rational(5, 7), Rational(2)};
  body.velocity = body.velocity + s + cross(t, from_origin(body.position));
  body.angular_velocity = body.angular_velocity + t;
  return body;
}

/// The same motion, told of the point of the body that is there.
template <class Body>
Body around(Body body, const Point3<Rational>& point) {
  body.velocity = body.velocity + cross(body.angular_velocity, point - body.position);
  body.position = point;
  return body;
}

/// Magnitudes instead of numbers, exactly: of vectors, of products and of what is added up.
template <class V>
Motion3 size_of(const V& v) {
  if constexpr (std::is_same_v<V, Motion3>) return {Rational(abs(v.x)), Rational(abs(v.y)), Rational(abs(v.z))};
  else return {Rational(abs(exact(v.x))), Rational(abs(exact(v.y))), Rational(abs(exact(v.z)))};
}
inline Motion3 cross_of_sizes(const Motion3& v, const Motion3& w) {
  return {Rational(v.y * w.z + v.z * w.y), Rational(v.z * w.x + v.x * w.z), Rational(v.x * w.y + v.y * w.x)};
}
/// The way from a body's position to a point.
template <class Body>
Motion3 arm_of(const Body& body, const Point3d& p) {
  const Point3d& x = body.position;
  return {Rational(exact(p.x) - exact(x.x)), Rational(exact(p.y) - exact(x.y)), Rational(exact(p.z) - exact(x.z))};
}
/// Of the velocity at a point.
template <class Body>
Motion3 size_at(const Body& body, const Point3d& p) {
  return size_of(body.velocity) + cross_of_sizes(size_of(body.angular_velocity), size_of(arm_of(body, p)));
}

}  // namespace touchstone::proptests
