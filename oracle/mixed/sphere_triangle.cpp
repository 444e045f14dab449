// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_triangle.h"

#include "oracle/exact/shapes/round_solid.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> sphere_triangle(const Sphere3<Number>& sphere, const Triangle3<Number>& triangle) {
  return contact_of_round("sphere", sphere, "triangle", triangle);
}
template Truth<Contact> sphere_triangle(const Sphere3d&, const Triangle3d&);
template Truth<Contact> sphere_triangle(const Sphere3<Rational>&, const Triangle3<Rational>&);

}  // namespace touchstone::oracle
