// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/volumes.h"

namespace touchstone::reference {

/// Two balls: the squared distance of the centres against the squared sum of the radii.
template <class Real>
bool pair_meets(const Sphere3<Real>& a, const Sphere3<Real>& b) {
  const Vector3<Real> between = b.center - a.center;
  const Real reach = Real(a.radius + b.radius);
  return dot(between, between) <= Real(reach * reach);
}

/// Two boxes: their intervals overlap on each axis.
template <class Real>
bool pair_meets(const Aabb3<Real>& a, const Aabb3<Real>& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

/// Called for each node that a search in a structure visits, with a flag that tells whether the search continues inside
/// it. This one does nothing.
struct Unseen {
  template <class Node>
  void operator()(const Node&, bool) const {}
};

template <class Solid>
std::vector<IndexPair> pairs_that_meet(const std::vector<Solid>& solids) {
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = i + 1; j < solids.size(); ++j) {
      if (pair_meets(solids[i], solids[j])) pairs.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    }
  }
  return pairs;
}

/// Finds which of several solids meet: the broad phase without any structure, each solid against each other one.
///
/// Deck p. 55-56: n (n - 1) / 2 tests, spheres by the squared distance of their centres (p. 44), boxes by intervals (p.
/// 45-47).
/// spheres, boxes: any unit of length, the same for all. Answer: the pairs of indices i < j in the list, sorted by i
/// and then by j.
/// Closed sets: solids that touch meet. A sphere of radius 0 and a box with min = max are points; equal solids meet,
/// and so does one within another. Fewer than two solids have no pairs; an empty list is valid.
/// NaN or infinity: refused by robust and oracle (field "spheres[i].center[k]", "spheres[i].radius", "boxes[i].min[k]",
/// "boxes[i].max[k]": "finite number"); so are a negative radius ("spheres[i].radius", "radius >= 0") and min > max
/// ("boxes[i].max[k]", "min <= max").
///
/// Rounding (binary64, to nearest, u = 2^-53), spheres: let S be the exact squared distance of a pair's centres and R
/// the exact square of the sum of its radii. Each square in S carries its difference's rounding twice and its own, and
/// goes through two sums at most: off by at most ((1 + u)^5 - 1) S <= (5 + 11u) u S, and where squares underflow by 3
/// (1 + u)^2 2^-1075. R has one rounding less of each sort: off by at most ((1 + u)^3 - 1) R <= (3 + 4u) u R and
/// 2^-1075. The comparison is exact. So the double version is right of every pair with |S - R| > (5 + 11u) u S + (3 +
/// 4u) u R + 2^-1072, unless S or R overflows.
/// Boxes are compared and not computed with: the double version is always right.
/// In exact arithmetic both are always right. No number is returned.
template <class Real>
std::vector<IndexPair> all_pairs(const std::vector<Sphere3<Real>>& spheres) {
  return pairs_that_meet(spheres);
}
template <class Real>
std::vector<IndexPair> all_pairs(const std::vector<Aabb3<Real>>& boxes) {
  return pairs_that_meet(boxes);
}

}  // namespace touchstone::reference
