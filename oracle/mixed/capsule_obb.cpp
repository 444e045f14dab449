// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_obb.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_obb(const Capsule3<Number>& capsule, const Obb3<Number>& obb) {
  return contact_of_round("capsule", capsule, "obb", obb);
}
template Truth<Contact> capsule_obb(const Capsule3d&, const Obb3d&);
template Truth<Contact> capsule_obb(const Capsule3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
