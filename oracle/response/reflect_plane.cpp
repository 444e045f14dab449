// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/reflect_plane.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Truth<Vector3<Rational>> truth_reflect_plane(const Vector3<Number>& velocity, const Vector3<Number>& normal) {
  validation::validate("velocity", velocity), validation::validate("normal", normal, rule::normal);
  return bounced(velocity, normal, Rational(1));
}

}  // namespace

Truth<Vector3<Rational>> reflect_plane(const Vector3d& velocity, const Vector3d& normal) {
  return truth_reflect_plane(velocity, normal);
}

template <Exact Number>
Truth<Vector3<Rational>> reflect_plane(const Vector3<Number>& velocity, const Vector3<Number>& normal) {
  return truth_reflect_plane(velocity, normal);
}
template Truth<Vector3<Rational>> reflect_plane(const Vector3<Rational>&, const Vector3<Rational>&);

}  // namespace touchstone::oracle
