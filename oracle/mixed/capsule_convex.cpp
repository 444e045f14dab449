// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/capsule_convex.h"

#include "oracle/exact/solids/round_and_convex.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_convex(const Capsule3<Number>& capsule, const Mesh<Number>& mesh) {
  return contact_with_convex("capsule", capsule, "mesh", mesh);
}
template Truth<Contact> capsule_convex(const Capsule3d&, const Meshd&);
template Truth<Contact> capsule_convex(const Capsule3<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
