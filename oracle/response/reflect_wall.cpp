// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/reflect_wall.h"

#include "oracle/exact/rational_validation.h"
#include "oracle/exact/space.h"

namespace touchstone::oracle {
namespace {

struct Bounce {
  Vector3<Rational> before, after;
};

template <class Number>
Bounce bounce(const Vector3<Number>& velocity, Axis axis) {
  validation::validate("velocity", velocity);
  const Vector3<Rational> v{exact(velocity.x), exact(velocity.y), exact(velocity.z)};
  const Vector3<Rational> normal{axis == Axis::x, axis == Axis::y, axis == Axis::z};
  const Vector3<Rational> twice_normal_part = Rational(2 * dot(v, normal)) * normal;
  return {v, {v.x - twice_normal_part.x, v.y - twice_normal_part.y, v.z - twice_normal_part.z}};
}

}  // namespace

Truth<Vector3<Rational>> reflect_wall(const Vector3d& velocity, Axis axis) {
  return {bounce(velocity, axis).after, std::nullopt};
}

template <Exact Number>
Truth<Vector3<Rational>> reflect_wall(const Vector3<Number>& velocity, Axis axis) {
  return {bounce(velocity, axis).after, std::nullopt};
}
template Truth<Vector3<Rational>> reflect_wall(const Vector3<Rational>&, Axis);

Certificate reflect_wall_certificate(const Vector3d& velocity, Axis axis) {
  const auto [before, after] = bounce(velocity, axis);
  return {"components", {{"squared_speeds", {dot(before, before), dot(after, after)}}}};
}

}  // namespace touchstone::oracle
