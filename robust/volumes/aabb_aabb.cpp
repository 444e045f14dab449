// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/aabb_aabb.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

/// The contact on one axis, as 0 or 1, so that axes are combined without branches, which touching boxes would
/// mispredict.
struct AxisContact {
  int apart;     ///< no common point
  int confined;  ///< no common interval of positive length
};

AxisContact contact_on_axis(double a_min, double a_max, double b_min, double b_max) {
  using kernel::ordered_bits;
  const auto low = std::max(ordered_bits(a_min), ordered_bits(b_min));
  const auto high = std::min(ordered_bits(a_max), ordered_bits(b_max));
  return {static_cast<int>(low > high), static_cast<int>(low >= high)};
}

AxisContact together(const AxisContact& s, const AxisContact& t) {
  return {s.apart | t.apart, s.confined | t.confined};
}

AxisContact on_all_axes(const Aabb2d& a, const Aabb2d& b) {
  return together(contact_on_axis(a.min.x, a.max.x, b.min.x, b.max.x),
                  contact_on_axis(a.min.y, a.max.y, b.min.y, b.max.y));
}
AxisContact on_all_axes(const Aabb3d& a, const Aabb3d& b) {
  return together(together(contact_on_axis(a.min.x, a.max.x, b.min.x, b.max.x),
                           contact_on_axis(a.min.y, a.max.y, b.min.y, b.max.y)),
                  contact_on_axis(a.min.z, a.max.z, b.min.z, b.max.z));
}

Contact contact_of(const AxisContact& all) {
  return all.apart != 0 ? Contact::disjoint : all.confined != 0 ? Contact::touching : Contact::overlapping;
}

template <class Box>
void validate_aabb_aabb(const Box& a, const Box& b) {
  if (!kernel::valid(a) || !kernel::valid(b)) validation::validate_all("a", a, "b", b);
}

}  // namespace

Contact stages::aabb_aabb::exact(const Aabb2d& a, const Aabb2d& b) { return contact_of(on_all_axes(a, b)); }
Contact stages::aabb_aabb::exact(const Aabb3d& a, const Aabb3d& b) { return contact_of(on_all_axes(a, b)); }

Decided<Contact> stages::aabb_aabb::past_filter(const Aabb2d& a, const Aabb2d& b) {
  return in_turn<aabb_aabb, validate_aabb_aabb<Aabb2d>, Stage::exact>(a, b);
}
Decided<Contact> stages::aabb_aabb::past_filter(const Aabb3d& a, const Aabb3d& b) {
  return in_turn<aabb_aabb, validate_aabb_aabb<Aabb3d>, Stage::exact>(a, b);
}

}  // namespace touchstone::robust
