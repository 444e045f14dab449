// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/sphere_sphere.h"

#include "robust/kernel/shapes/spheres.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

Perhaps<Contact> stages::sphere_sphere::lattice(const Ball& a, const Ball& b) {
  const Perhaps<int> reach = kernel::Reach::lattice(a, b);
  if (!reach) return std::nullopt;
  return contact(*reach, a, b);
}

Contact stages::sphere_sphere::exact(const Ball& a, const Ball& b) { return contact(kernel::Reach::exact(a, b), a, b); }

namespace {

/// A disc's ball has the disc's field names, and a third coordinate that is always valid.
void validate_sphere_sphere(const Sphere3d& a, const Sphere3d& b) {
  if (!kernel::valid(a) || !kernel::valid(b)) validation::validate_all("a", a, "b", b);
}

}  // namespace

Decided<Contact> stages::sphere_sphere::past_filter(const Ball& a, const Ball& b) {
  return in_turn<sphere_sphere, validate_sphere_sphere, Stage::lattice, Stage::exact>(a, b);
}

}  // namespace touchstone::robust
