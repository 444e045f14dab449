// SPDX-License-Identifier: Apache-2.0
#include "oracle/planes/capsule_plane.h"

#include "oracle/exact/shapes/half_space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> capsule_plane(const Capsule3<Number>& capsule, const Plane<Number>& plane) {
  return contact_over_plane("capsule", capsule, plane);
}
template Truth<Contact> capsule_plane(const Capsule3d&, const Plane3d&);
template Truth<Contact> capsule_plane(const Capsule3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
