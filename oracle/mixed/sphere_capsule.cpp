// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_capsule.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> sphere_capsule(const Sphere3<Number>& sphere, const Capsule3<Number>& capsule) {
  return contact_of_round("sphere", sphere, "capsule", capsule);
}
template Truth<Contact> sphere_capsule(const Sphere3d&, const Capsule3d&);
template Truth<Contact> sphere_capsule(const Sphere3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
