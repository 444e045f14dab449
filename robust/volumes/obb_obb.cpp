// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/obb_obb.h"

#include <array>

#include "robust/kernel/filters/obb_filter.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/separating_axes.h"

namespace touchstone::robust {

Perhaps<Contact> stages::obb_obb::filter(const Obb3d& a, const Obb3d& b) {
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  const std::array<Vector3d, 6> edges{u, v, w, x, y, z};
  const filters::ObbAxes<double> pair(edges, b.center - a.center);
  if (!pair.independent()) [[unlikely]]
    return std::nullopt;
  return kernel::contact_by_signs(
      edges, [&pair](const kernel::Spanned& axis) { return pair.on_axis(axis.v, axis.w, axis.others); });
}

namespace {

template <class Integer>
Contact contact(const std::array<Integer, 24>& n) {
  const auto at = [&n](std::size_t i) { return kernel::vector_at(n, i); };
  const std::array<Vector3<Integer>, 6> edges{at(3), at(6), at(9), at(15), at(18), at(21)};
  return kernel::contact_by_axes(edges, edges, at(12) - at(0));
}

/// `numbers` takes any count of doubles.
template <class Numbers>
auto numbers_of(const Obb3d& a, const Obb3d& b, const Numbers& numbers) {
  const Point3d &c = a.center, &d = b.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  return numbers(c.x, c.y, c.z, u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z,  //
                 d.x, d.y, d.z, x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z);
}

void validate_obb_obb(const Obb3d& a, const Obb3d& b) {
  if (!kernel::valid(b) && kernel::valid(a)) validation::validate_numbers("b", b);  // before the rules of a
  kernel::validate_obb("a", a), kernel::validate_obb("b", b);
}

}  // namespace

Perhaps<Contact> stages::obb_obb::lattice(const Obb3d& a, const Obb3d& b) {
  const auto lattice = numbers_of(a, b, [](auto... n) { return kernel::lattice_of(n...); });
  if (!lattice) return std::nullopt;
  return contact(lattice->at);
}

Contact stages::obb_obb::exact(const Obb3d& a, const Obb3d& b) {
  return contact(numbers_of(a, b, [](auto... n) { return kernel::integers_of(n...); }).at);
}

Decided<Contact> stages::obb_obb::ask(const Obb3d& a, const Obb3d& b) {
  return in_turn<obb_obb, Stage::filter, validate_obb_obb, Stage::lattice, Stage::exact>(a, b);
}

Contact obb_obb(const Obb3d& a, const Obb3d& b) { return stages::obb_obb::ask(a, b).answer; }

}  // namespace touchstone::robust
