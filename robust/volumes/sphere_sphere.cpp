// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/sphere_sphere.h"

#include "robust/kernel/spheres.h"
#include "robust/kernel/valid_space.h"

namespace touchstone::robust {

std::optional<Contact> sphere_sphere_lattice(const Sphere3d& a, const Sphere3d& b) {
  const std::optional<int> reach = kernel::reach_lattice(a, b);
  if (!reach) return std::nullopt;
  return sphere_sphere_for(*reach, a, b);
}

Contact sphere_sphere_exact(const Sphere3d& a, const Sphere3d& b) {
  return sphere_sphere_for(kernel::reach_exact(a, b), a, b);
}

/// A disc's ball has the disc's field names, and a third coordinate that is always valid.
Contact sphere_sphere_past_filter(const Sphere3d& a, const Sphere3d& b, Stage& decided) {
  if (!kernel::valid(a) || !kernel::valid(b)) validation::validate("a", a), validation::validate("b", b);
  return sphere_sphere_for(kernel::reach_past_filter(a, b, decided), a, b);
}

}  // namespace touchstone::robust
