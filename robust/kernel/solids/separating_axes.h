// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/answers.h"
#include "geometry/validation.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/solids/parallelepiped.h"

/// The separating axes of two parallelepipeds. `edges`: the directions of the edges of a, then of b.
namespace touchstone::robust::kernel {

/// An axis: the cross product of two of the six edges, a's before b's; and the four others. First the normals of
/// a's faces, then of b's, then of an edge of a and an edge of b.
struct Spanned {
  std::size_t v, w;
  std::array<std::size_t, 4> others;
};
inline constexpr std::array<Spanned, 15> axes_of_boxes{{{1, 2, {0, 3, 4, 5}},
                                                        {2, 0, {1, 3, 4, 5}},
                                                        {0, 1, {2, 3, 4, 5}},
                                                        {4, 5, {3, 0, 1, 2}},
                                                        {5, 3, {4, 0, 1, 2}},
                                                        {3, 4, {5, 0, 1, 2}},
                                                        {0, 3, {1, 2, 4, 5}},
                                                        {0, 4, {1, 2, 3, 5}},
                                                        {0, 5, {1, 2, 3, 4}},
                                                        {1, 3, {0, 2, 4, 5}},
                                                        {1, 4, {0, 2, 3, 5}},
                                                        {1, 5, {0, 2, 3, 4}},
                                                        {2, 3, {0, 1, 4, 5}},
                                                        {2, 4, {0, 1, 3, 5}},
                                                        {2, 5, {0, 1, 3, 4}}}};

/// True if v x w is certainly zero: in each of its products a factor is 0, or one vector is the other or its opposite.
/// Compares bits: no subnormal is read as 0. (Boxes with a common orientation are frequent.)
inline bool parallel(const Vector3d& v, const Vector3d& w) {
  using validation::same, validation::zero;
  if (same(v.x, w.x) && same(v.y, w.y) && same(v.z, w.z)) return true;
  if (same(v.x, -w.x) && same(v.y, -w.y) && same(v.z, -w.z)) return true;
  const auto no_product = [](double x, double y) { return zero(x) || zero(y); };
  return no_product(v.y, w.z) && no_product(v.z, w.y) && no_product(v.z, w.x) && no_product(v.x, w.z) &&
         no_product(v.x, w.y) && no_product(v.y, w.x);
}

/// The contact by the signs of a filter, which on_axis(axis) gives: positive if the axis separates, negative if the
/// boxes have a common interval of positive length along it. Empty if it is not certain.
template <class OnAxis>
Perhaps<Contact> contact_by_signs(const std::array<Vector3d, 6>& edges, const OnAxis& on_axis) {
  bool unknown = false;
  for (const Spanned& axis : axes_of_boxes) {
    const filters::Sign apart = on_axis(axis);
    if (apart == filters::Sign::positive) return Contact::disjoint;
    if (apart == filters::Sign::unknown) [[unlikely]]
      unknown = unknown || !parallel(edges[axis.v], edges[axis.w]);
  }
  if (unknown) [[unlikely]]
    return std::nullopt;
  return Contact::overlapping;
}

/// On each nonzero axis compares the displacement of the centers with the sum of the reaches of half axes, which have
/// the directions of the edges.
template <class Integer>
Contact contact_by_axes(const std::array<Vector3<Integer>, 6>& edges, const std::array<Vector3<Integer>, 6>& half_axes,
                        const Vector3<Integer>& displacement) {
  bool touching = false;
  for (const Spanned& each : axes_of_boxes) {
    const auto axis = axis_across(edges[each.v], edges[each.w]);
    if (sign_of(axis.x) == 0 && sign_of(axis.y) == 0 && sign_of(axis.z) == 0) continue;
    Third<Integer> gap = along_axis(axis, displacement);
    for (const std::size_t other : each.others) gap = gap + -along_axis(axis, half_axes[other]);
    const int apart = sign_of(gap);
    if (apart > 0) return Contact::disjoint;
    touching = touching || apart == 0;
  }
  return touching ? Contact::touching : Contact::overlapping;
}

}  // namespace touchstone::robust::kernel
