// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/reflect_wall.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Vector3<Rational>> reflect_wall(const Vector3<Number>& velocity, Axis axis) {
  validation::validate("velocity", velocity);
  Vector3<Rational> v{exact(velocity.x), exact(velocity.y), exact(velocity.z)};
  const Vector3<Rational> normal{axis == Axis::x, axis == Axis::y, axis == Axis::z};
  const Vector3<Rational> twice_normal_part = Rational(2 * dot(v, normal)) * normal;
  Vector3<Rational> after = v - twice_normal_part;
  return {after, std::nullopt, [before = std::move(v), after] {
            return Certificate{"components", {{"squared_speeds", {dot(before, before), dot(after, after)}}}};
          }};
}
template Truth<Vector3<Rational>> reflect_wall(const Vector3d&, Axis);
template Truth<Vector3<Rational>> reflect_wall(const Vector3<Rational>&, Axis);

}  // namespace touchstone::oracle
