// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/reflect_plane.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Vector3<Rational>> reflect_plane(const Vector3<Number>& velocity, const Vector3<Number>& normal) {
  validation::validate("velocity", velocity), validation::validate("normal", normal, rule::normal);
  return bounced(velocity, normal, Rational(1));
}
template Truth<Vector3<Rational>> reflect_plane(const Vector3d&, const Vector3d&);
template Truth<Vector3<Rational>> reflect_plane(const Vector3<Rational>&, const Vector3<Rational>&);

}  // namespace touchstone::oracle
