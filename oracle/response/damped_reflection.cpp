// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/damped_reflection.h"

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Vector3<Rational>> damped_reflection(const Vector3<Number>& velocity, const Vector3<Number>& normal,
                                           const Number& k) {
  validation::validate_all("velocity", velocity, "normal", validation::under(rule::normal, normal), "k", k);
  return bounced(velocity, normal, exact(k));
}
template Truth<Vector3<Rational>> damped_reflection(const Vector3d&, const Vector3d&, const double&);
template Truth<Vector3<Rational>> damped_reflection(const Vector3<Rational>&, const Vector3<Rational>&,
                                                    const Rational&);

}  // namespace touchstone::oracle
