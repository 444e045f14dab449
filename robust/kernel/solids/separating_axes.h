// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "geometry/answers.h"
#include "geometry/validation.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/solids/axes_of_boxes.h"
#include "robust/kernel/solids/parallelepiped.h"

/// The separating axes of two parallelepipeds, or of one and a triangle. `edges`: the directions of the edges of a,
/// then of b; the three sides of a triangle span one normal thrice.
namespace touchstone::robust::kernel {

/// True if in each product of v x w a factor is 0. Compares bits: no subnormal is read as 0. (Common orientations are
/// frequent.)
inline bool without_products(const Vector3d& v, const Vector3d& w) {
  const auto no_product = [](double x, double y) { return validation::zero(x) || validation::zero(y); };
  return no_product(v.y, w.z) && no_product(v.z, w.y) && no_product(v.z, w.x) && no_product(v.x, w.z) &&
         no_product(v.x, w.y) && no_product(v.y, w.x);
}
/// True if v x w is certainly zero: so, or one vector is the other or its opposite.
inline bool parallel(const Vector3d& v, const Vector3d& w) {
  using validation::same;
  if (same(v.x, w.x) && same(v.y, w.y) && same(v.z, w.z)) return true;
  if (same(v.x, -w.x) && same(v.y, -w.y) && same(v.z, -w.z)) return true;
  return without_products(v, w);
}

/// The contact by the signs of a filter, which on_axis(axis) gives: positive if the axis separates, negative if both
/// have a common interval of positive length along it. Empty if it is not certain. is_zero(v, w): whether the axis of
/// two edges is certainly zero.
template <class OnAxis, class IsZero = decltype(&parallel)>
Perhaps<Contact> contact_by_signs(const std::array<Vector3d, 6>& edges, const OnAxis& on_axis,
                                  const IsZero& is_zero = &parallel) {
  bool unknown = false;
  for (const Spanned& axis : axes_of_boxes) {
    const filters::Sign apart = on_axis(axis);
    if (apart == filters::Sign::positive) return Contact::disjoint;
    if (apart == filters::Sign::unknown) [[unlikely]]
      unknown = unknown || !is_zero(edges[axis.v], edges[axis.w]);
  }
  if (unknown) [[unlikely]]
    return std::nullopt;
  return Contact::overlapping;
}

/// The contact by the signs of exact numbers: of apart(axis, others), how far both are apart along an axis that is not
/// zero.
template <class Integer, class Apart>
Contact contact_by_exact_signs(const std::array<Vector3<Integer>, 6>& edges, const Apart& apart) {
  bool touching = false;
  for (const Spanned& each : axes_of_boxes) {
    const auto axis = axis_across(edges[each.v], edges[each.w]);
    if (sign_of(axis.x) == 0 && sign_of(axis.y) == 0 && sign_of(axis.z) == 0) continue;
    const int sign = apart(axis, each.others);
    if (sign > 0) return Contact::disjoint;
    touching = touching || sign == 0;
  }
  return touching ? Contact::touching : Contact::overlapping;
}

/// Compares the displacement of the centers with the sum of the reaches of half axes, which have the directions of the
/// edges.
template <class Integer>
Contact contact_by_axes(const std::array<Vector3<Integer>, 6>& edges, const std::array<Vector3<Integer>, 6>& half_axes,
                        const Vector3<Integer>& displacement) {
  return contact_by_exact_signs(edges, [&](const auto& axis, const auto& others) {
    Third<Integer> gap = along_axis(axis, displacement);
    for (const std::size_t other : others) gap = gap + -along_axis(axis, half_axes[other]);
    return sign_of(gap);
  });
}

/// Compares the corners of a triangle, as seen from the center of a box, with the reach of the box to either side. On a
/// lattice corners are below 2^63, and heights below 2^190.
template <class Integer>
Contact contact_with_triangle(const std::array<Vector3<Integer>, 6>& edges,
                              const std::array<Vector3<Integer>, 3>& half_axes,
                              const std::array<Vector3<Integer>, 3>& corners) {
  return contact_by_exact_signs(edges, [&](const auto& axis, const auto&) {
    Third<Integer> back = -along_axis(axis, half_axes[0]);
    for (std::size_t k = 1; k < 3; ++k) back = back + -along_axis(axis, half_axes[k]);
    int above = 1, below = 1;
    for (const Vector3<Integer>& corner : corners) {
      const Third<Integer> height = product_with_axis(axis, corner);
      above = std::min(above, sign_of(Third<Integer>(height + back)));
      below = std::min(below, sign_of(Third<Integer>(-height + back)));
    }
    return std::max(above, below);
  });
}

}  // namespace touchstone::robust::kernel
