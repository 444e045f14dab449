// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_aabb.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_aabb(const Capsule3<Number>& capsule, const Aabb3<Number>& aabb) {
  return contact_of_round("capsule", capsule, "aabb", aabb);
}
template Truth<Contact> capsule_aabb(const Capsule3d&, const Aabb3d&);
template Truth<Contact> capsule_aabb(const Capsule3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
