// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/point_in_kdop.h"

#include <algorithm>

#include "robust/kernel/filters/slab_filter.h"
#include "robust/kernel/integers/plane_terms.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

/// Tests all slabs, even after one that excludes the point: each of them has to be valid.
Perhaps<Location> stages::point_in_kdop::filter(const Kdop3d& kdop, const Point3d& point) {
  const std::size_t count = kdop.normals.size();
  if (count == 0 || kdop.slabs.size() != count) return std::nullopt;
  filters::SlabDepths<double> depths(point, kdop.normals[0], kdop.slabs[0]);
  for (std::size_t i = 1; i < count; ++i) depths.add(kdop.normals[i], kdop.slabs[i]);
  return filters::by_sign(depths.sign(), Location::inside, Location::outside);
}

namespace {

using filters::Sign;

/// The lesser of the signs of N . P - d1 and of d2 - N . P: 1 within a slab, 0 at an end, -1 beyond one. sum(terms):
/// the exact sum, if it can compute it.
template <class Sum>
std::optional<int> depth(const Vector3d& normal, const Slabd& slab, const Point3d& point, const Sum& sum) {
  const auto over = sum(kernel::height_over({normal, -slab.min}, point)),
             beyond = sum(kernel::height_over({normal, -slab.max}, point));
  if (!over || !beyond) return std::nullopt;
  return std::min(kernel::sign_of(over->n), -kernel::sign_of(beyond->n));
}

/// The least of the depths in all slabs.
template <class Depth>
Perhaps<Location> location(const Kdop3d& kdop, const Depth& depth) {
  bool unknown = false, on = false;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const std::optional<int> found = depth(kdop.normals[i], kdop.slabs[i]);
    if (found && *found < 0) return Location::outside;
    unknown = unknown || !found;
    on = on || (found && *found == 0);
  }
  if (unknown) return std::nullopt;
  return on ? Location::boundary : Location::inside;
}

void validate_point_in_kdop(const Kdop3d& kdop, const Point3d& point) {
  if (kernel::valid(kdop) && kernel::valid(point)) return;
  validation::validate_all("kdop", kdop, "point", point);
}

}  // namespace

Perhaps<Location> stages::point_in_kdop::lattice(const Kdop3d& kdop, const Point3d& point) {
  return location(kdop, [&](const Vector3d& normal, const Slabd& slab) -> std::optional<int> {
    const Sign sign = filters::slab<double>(normal, slab, point);
    if (sign != Sign::unknown) return sign == Sign::positive ? 1 : -1;
    return depth(normal, slab, point, [](const auto& terms) { return kernel::lattice_sum(terms); });
  });
}

Location stages::point_in_kdop::exact(const Kdop3d& kdop, const Point3d& point) {
  return *location(kdop, [&](const Vector3d& normal, const Slabd& slab) {
    return depth(normal, slab, point, [](const auto& terms) { return std::optional(kernel::exact_sum(terms)); });
  });
}

Decided<Location> stages::point_in_kdop::ask(const Kdop3d& kdop, const Point3d& point) {
  return in_turn<point_in_kdop, Stage::filter, validate_point_in_kdop, Stage::lattice, Stage::exact>(kdop, point);
}

Location point_in_kdop(const Kdop3d& kdop, const Point3d& point) {
  return stages::point_in_kdop::ask(kdop, point).answer;
}

}  // namespace touchstone::robust
