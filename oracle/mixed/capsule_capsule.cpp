// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_capsule.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b) {
  return contact_of_round("a", a, "b", b);
}
template Truth<Contact> capsule_capsule(const Capsule3d&, const Capsule3d&);
template Truth<Contact> capsule_capsule(const Capsule3<Rational>&, const Capsule3<Rational>&);

}  // namespace touchstone::oracle
