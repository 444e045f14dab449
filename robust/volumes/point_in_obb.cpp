// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/point_in_obb.h"

#include <algorithm>

#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

/// With center, half axes and point over one power of two. point - center = r u + s v + t w, where by Cramer's rule r
/// is the quotient of two determinants, of point - center with v and w and of u with them; |r| is compared with 1.
template <class Integer>
Location located(const std::array<Integer, 15>& n) {
  const Vector3<Integer> u = kernel::vector_at(n, 3), v = kernel::vector_at(n, 6), w = kernel::vector_at(n, 9),
                         d{n[12] - n[0], n[13] - n[1], n[14] - n[2]};
  const auto beyond = [&d](const Vector3<Integer>& half_axis, const Vector3<Integer>& one,
                           const Vector3<Integer>& other) {
    const auto axis = kernel::axis_across(one, other);
    return kernel::sign_of(kernel::Third<Integer>(kernel::along_axis(axis, d) + -kernel::along_axis(axis, half_axis)));
  };
  const int farthest = std::max({beyond(u, v, w), beyond(v, w, u), beyond(w, u, v)});
  return farthest > 0 ? Location::outside : farthest < 0 ? Location::inside : Location::boundary;
}

/// `numbers` takes any count of doubles.
template <class Numbers>
auto numbers_of(const Obb3d& obb, const Point3d& p, const Numbers& numbers) {
  const auto& [u, v, w] = obb.half_axes;
  const Point3d& c = obb.center;
  return numbers(c.x, c.y, c.z, u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z, p.x, p.y, p.z);
}

void validate_point_in_obb(const Obb3d& obb, const Point3d& point) {
  if (!kernel::valid(point) && kernel::valid(obb)) validation::validate("point", point);  // before the rules of the box
  kernel::validate_obb("obb", obb);
}

}  // namespace

Perhaps<Location> stages::point_in_obb::lattice(const Obb3d& obb, const Point3d& point) {
  const auto lattice = numbers_of(obb, point, [](auto... n) { return kernel::lattice_of(n...); });
  if (!lattice) return std::nullopt;
  return located(lattice->at);
}

Location stages::point_in_obb::exact(const Obb3d& obb, const Point3d& point) {
  return located(numbers_of(obb, point, [](auto... n) { return kernel::integers_of(n...); }).at);
}

Decided<Location> stages::point_in_obb::past_filter(const Obb3d& obb, const Point3d& point) {
  return in_turn<point_in_obb, validate_point_in_obb, Stage::lattice, Stage::exact>(obb, point);
}

}  // namespace touchstone::robust
