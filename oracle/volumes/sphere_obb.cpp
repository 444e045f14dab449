// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/sphere_obb.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> sphere_obb(const Sphere3<Number>& sphere, const Obb3<Number>& obb) {
  return contact_of_round("sphere", sphere, "obb", obb);
}
template Truth<Contact> sphere_obb(const Sphere3d&, const Obb3d&);
template Truth<Contact> sphere_obb(const Sphere3<Rational>&, const Obb3<Rational>&);

}  // namespace touchstone::oracle
