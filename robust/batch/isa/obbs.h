// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/vectors.h"
#include "robust/kernel/solids/axes_of_boxes.h"

/// The filter of two parallelepipeds: the model and the constants of kernels.h. Proved by machine from this text
/// (robust/proofs/lane_obb.v, lane_obb_axes.v), with the theorem that all axes together decide (zonotope.v).
namespace touchstone::robust::batch::isa {
namespace {

/// The axes, so that nothing of the standard library is called.
struct Axes {
  struct {
    std::size_t e, f, others[4];
  } of[kernel::axes_of_boxes.size()] = {};
  constexpr Axes() {
    std::size_t i = 0;
    for (const auto& [e, f, others] : kernel::axes_of_boxes)
      of[i++] = {e, f, {others[0], others[1], others[2], others[3]}};
  }
};
constexpr Axes axes;

/// Separating axes, as filters::ObbAxes has them for one question: for an axis n = e x f of two edges, |n . d| is
/// compared with the sum of |n . g| over the four other half axes g. d is the computed difference of the centers.
///
/// With |x| for the sum of a vector's magnitudes, let S = |d| + the sum of |g| over all six. Every value is off by less
/// than 7 v |e| |f| S: a product of three coordinates goes through a difference, a product and a difference in n, a
/// product and two sums, or through one difference less and two sums more; the last difference cannot make a sign
/// wrong. C = 8 v, though the size goes through 16 roundings. The product of sizes is 2^-1000 too large, which covers
/// underflow in n. No product of three or sum of such overflows unless the 2^8 times larger size does, and every number
/// is in S.
///
/// An axis that is exactly zero separates nothing and is left out: each product in it has a factor 0, or the edges are
/// equal or opposite. Half axes that may be dependent are left to other stages.
struct ObbObb {
  static constexpr std::size_t columns = 24;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping

  static Verdict of(const Lanes* c) {
    const InSpace edges[] = {InSpace(c + 3),  InSpace(c + 6),  InSpace(c + 9),
                             InSpace(c + 15), InSpace(c + 18), InSpace(c + 21)};
    const InSpace way = InSpace(c + 12) - InSpace(c);
    Lanes sizes[6], sum = size_of(way);
    for (std::size_t k = 0; k < 6; ++k) sizes[k] = size_of(edges[k]), sum = sum + sizes[k];
    const auto bound = [&sizes, sum](std::size_t e, std::size_t f) {
      const Lanes size = multiply_add(sizes[e] * same(0x1p8), sizes[f], same(tiny)) * sum;
      return multiply_add(size, same(0x1p-8 * 8 * v), same(tiny));
    };
    const auto certain_volume = [&edges, &bound](std::size_t k) {
      return above(magnitude(dot(cross(edges[k], edges[k + 1]), edges[k + 2])), bound(k, k + 1));
    };
    const Mask solid = certain_volume(0) & certain_volume(3);
    Mask apart = 0, meets = all_lanes;
    for (const auto& axis : axes.of) {
      const InSpace &e = edges[axis.e], &f = edges[axis.f], n = cross(e, f);
      const auto along = [&n](const InSpace& x) { return magnitude(dot(n, x)); };
      const auto& [p, q, r, s] = axis.others;
      const Lanes reach = (along(edges[p]) + along(edges[q])) + (along(edges[r]) + along(edges[s]));
      const Lanes gap = along(way) - reach, error = bound(axis.e, axis.f);
      apart |= above(gap, error);
      Mask meets_here = above(same(0) - gap, error);
      if (((apart | meets_here) & all_lanes) != all_lanes) meets_here |= zero(e, f);
      meets &= meets_here;
      if ((apart & all_lanes) == all_lanes) break;
    }
    return {solid & (apart | meets), apart};
  }

 private:
  /// The lanes in which e x f is certainly zero.
  static Mask zero(const InSpace& e, const InSpace& f) {
    const InSpace a = magnitudes(e), b = magnitudes(f), sum = e + f, difference = e - f;
    const Lanes products = greater(greater(lesser(a.y, b.z), lesser(a.z, b.y)),
                                   greater(greater(lesser(a.z, b.x), lesser(a.x, b.z)),
                                           greater(lesser(a.x, b.y), lesser(a.y, b.x))));
    return equal(products, same(0)) | equal(size_of(sum), same(0)) | equal(size_of(difference), same(0));
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
