// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/reflect_plane.h"

#include "oracle/exact/impact.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Vector3<Rational>> truth(const Vector3<Number>& velocity, const Vector3<Number>& normal) {
  validation::validate("velocity", velocity), validation::validate_normal("normal", normal);
  return {after_bounce(velocity, normal, Rational(1)), std::nullopt};
}

}  // namespace

Truth<Vector3<Rational>> reflect_plane(const Vector3d& velocity, const Vector3d& normal) {
  return truth(velocity, normal);
}

template <Exact Number>
Truth<Vector3<Rational>> reflect_plane(const Vector3<Number>& velocity, const Vector3<Number>& normal) {
  return truth(velocity, normal);
}
template Truth<Vector3<Rational>> reflect_plane(const Vector3<Rational>&, const Vector3<Rational>&);

Certificate reflect_plane_certificate(const Vector3d& velocity, const Vector3d& normal) {
  truth(velocity, normal);  // validates
  const Vector3<Rational> across = after_bounce(velocity, normal, Rational(0));
  return {"decomposition", {{"along", listed(exact_vector(velocity) - across)}, {"across", listed(across)}}};
}

}  // namespace touchstone::oracle
