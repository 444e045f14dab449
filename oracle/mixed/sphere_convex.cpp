// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/sphere_convex.h"

#include "oracle/exact/solids/round_and_convex.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<Contact> sphere_convex(const Sphere3<Number>& sphere, const Mesh<Number>& mesh) {
  return contact_with_convex("sphere", sphere, "mesh", mesh);
}
template Truth<Contact> sphere_convex(const Sphere3d&, const Meshd&);
template Truth<Contact> sphere_convex(const Sphere3<Rational>&, const Mesh<Rational>&);

}  // namespace touchstone::oracle
