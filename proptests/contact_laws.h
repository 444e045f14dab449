// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/described_bodies.h"
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

}  // namespace touchstone::proptests
