// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_plane.h"

#include "oracle/exact/shapes/half_space.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> sphere_plane(const Sphere3<Number>& sphere, const Plane<Number>& plane) {
  return contact_over_plane("sphere", sphere, plane);
}
template Truth<Contact> sphere_plane(const Sphere3d&, const Plane3d&);
template Truth<Contact> sphere_plane(const Sphere3<Rational>&, const Plane<Rational>&);

}  // namespace touchstone::oracle
