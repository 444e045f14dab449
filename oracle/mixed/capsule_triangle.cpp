// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_triangle.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_triangle(const Capsule3<Number>& capsule, const Triangle3<Number>& triangle) {
  return contact_of_round("capsule", capsule, "triangle", triangle);
}
template Truth<Contact> capsule_triangle(const Capsule3d&, const Triangle3d&);
template Truth<Contact> capsule_triangle(const Capsule3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
