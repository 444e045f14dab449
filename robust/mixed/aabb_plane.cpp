// SPDX-License-Identifier: Apache-2.0
#include "robust/mixed/aabb_plane.h"

#include "robust/kernel/filters/plane_filter.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The corner of least height. The normal's sign is read from its bits; if the coordinate is 0 either end will do.
Point3d lowest_corner(const Aabb3d& box, const Vector3d& n) {
  const auto end = [](double slope, double min, double max) { return kernel::sign_bit(slope) ? max : min; };
  return {end(n.x, box.min.x, box.max.x), end(n.y, box.min.y, box.max.y), end(n.z, box.min.z, box.max.z)};
}

bool flat(const Aabb3d& box) {
  return validation::same(box.min.x, box.max.x) || validation::same(box.min.y, box.max.y) ||
         validation::same(box.min.z, box.max.z);
}

/// The contact by the sign of the least height.
Contact contact(int sign, const Aabb3d& box) {
  if (sign > 0) return Contact::disjoint;
  return sign < 0 && !flat(box) ? Contact::overlapping : Contact::touching;
}

void validate_aabb_plane(const Aabb3d& aabb, const Plane3d& plane) {
  if (kernel::valid(aabb) && kernel::valid(plane)) return;
  validation::validate_all("aabb", aabb, "plane", plane);
}

}  // namespace

Perhaps<Contact> stages::aabb_plane::filter(const Aabb3d& aabb, const Plane3d& plane) {
  const filters::Sign sign = filters::plane(plane, lowest_corner(aabb, plane.normal));
  return filters::by_sign(sign, contact(1, aabb), contact(-1, aabb));
}

Perhaps<Contact> stages::aabb_plane::lattice(const Aabb3d& aabb, const Plane3d& plane) {
  const auto height = kernel::lattice_sum(kernel::height_over(plane, lowest_corner(aabb, plane.normal)));
  if (!height) return std::nullopt;
  return contact(kernel::sign_of(height->n), aabb);
}

Contact stages::aabb_plane::exact(const Aabb3d& aabb, const Plane3d& plane) {
  const auto height = kernel::exact_sum(kernel::height_over(plane, lowest_corner(aabb, plane.normal)));
  return contact(sgn(height.n), aabb);
}

/// The filter reads only one corner, so the box is validated before it.
Decided<Contact> stages::aabb_plane::ask(const Aabb3d& aabb, const Plane3d& plane) {
  return in_turn<aabb_plane, validate_aabb_plane, Stage::filter, Stage::lattice, Stage::exact>(aabb, plane);
}

Contact aabb_plane(const Aabb3d& aabb, const Plane3d& plane) { return stages::aabb_plane::ask(aabb, plane).answer; }

}  // namespace touchstone::robust
