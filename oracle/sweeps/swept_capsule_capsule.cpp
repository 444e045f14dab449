// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_capsule_capsule.h"

#include "geometry/validation.h"
#include "oracle/exact/moving/ball_near_polygon.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<FirstContact<Surd>> swept_capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b,
                                                const Vector3<Number>& velocity) {
  validation::validate_all("a", a, "b", b, "velocity", velocity);
  const Point3<Rational> p = exact(a.segment.a), q = exact(a.segment.b), c = exact(b.segment.a), d = exact(b.segment.b);
  const Vector3<Rational> back = p - q;
  return first_contact({{c, d, d + back, c + back},
                        p,
                        {exact(velocity.x), exact(velocity.y), exact(velocity.z)},
                        Rational(exact(a.radius) + exact(b.radius))});
}
template Truth<FirstContact<Surd>> swept_capsule_capsule(const Capsule3d&, const Capsule3d&, const Vector3d&);
template Truth<FirstContact<Surd>> swept_capsule_capsule(const Capsule3<Rational>&, const Capsule3<Rational>&,
                                                         const Vector3<Rational>&);

}  // namespace touchstone::oracle
