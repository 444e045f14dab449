// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/broad_phase/all_pairs.h"

namespace touchstone::reference {

/// The ball of a leaf: of a ball itself, of a box the one through its corners.
template <class Real>
Sphere3<Real> ball_around(const Sphere3<Real>& ball) {
  return ball;
}
template <class Real>
Sphere3<Real> ball_around(const Aabb3<Real>& box) {
  using std::sqrt;
  const Vector3<Real> diagonal = box.max - box.min;
  const Real half = Real(Real(1) / Real(2));
  return {box.min + half * diagonal, Real(half * Real(sqrt(dot(diagonal, diagonal))))};
}
/// The least ball around two: one of them, or from the far end of one to the far end of the other.
template <class Real>
Sphere3<Real> ball_around(const Sphere3<Real>& a, const Sphere3<Real>& b) {
  using std::sqrt;
  const Vector3<Real> between = b.center - a.center;
  const Real distance = Real(sqrt(dot(between, between)));
  if (Real(distance + b.radius) <= a.radius) return a;
  if (Real(distance + a.radius) <= b.radius) return b;
  const Real radius = Real((distance + a.radius + b.radius) / Real(2));
  return {a.center + Real((radius - a.radius) / distance) * between, radius};
}

/// Solids in balls around them; a solid that misses a ball misses everything in it.
template <class Real, class Solid>
class SphereHierarchy {
 public:
  explicit SphereHierarchy(const std::vector<std::pair<Index, Solid>>& solids) : ball_(ball_around(solids[0].second)) {
    if (solids.size() == 1) {
      place_ = solids[0].first;
      return;
    }
    const auto half = solids.begin() + static_cast<std::ptrdiff_t>(solids.size() / 2);
    children_.emplace_back(std::vector<std::pair<Index, Solid>>(solids.begin(), half));
    children_.emplace_back(std::vector<std::pair<Index, Solid>>(half, solids.end()));
    ball_ = ball_around(children_[0].ball_, children_[1].ball_);
  }

  template <class Found, class See = Unseen>
  void search(const Sphere3<Real>& ball, const Found& found, const See& see = {}) const {
    const bool entered = pair_meets(ball_, ball);
    see(*this, entered);
    if (!entered) return;
    if (children_.empty()) found(place_);
    for (const SphereHierarchy& child : children_) child.search(ball, found, see);
  }
  const Sphere3<Real>& volume() const { return ball_; }
  const std::vector<SphereHierarchy>& children() const { return children_; }

 private:
  Sphere3<Real> ball_;
  Index place_ = 0;  ///< of a leaf
  std::vector<SphereHierarchy> children_;
};

template <class Real, class Solid>
std::vector<IndexPair> pairs_in_hierarchy(const std::vector<Solid>& solids) {
  if (solids.empty()) return {};
  std::vector<std::pair<Index, Solid>> in_order;
  for (Index i = 0; i < solids.size(); ++i) in_order.emplace_back(i, solids[i]);
  const SphereHierarchy<Real, Solid> hierarchy(in_order);
  std::vector<IndexPair> pairs;
  for (Index i = 0; i < solids.size(); ++i) {
    hierarchy.search(ball_around(solids[i]), [&](Index j) {
      if (i < j && pair_meets(solids[i], solids[j])) pairs.push_back({i, j});
    });
  }
  return pairs;
}

/// Answers `all_pairs` by a hierarchy of spheres.
///
/// Deck p. 58-61: each node is a ball around two others, the list is halved in its order, and a solid is compared with
/// what is below the balls that its own ball meets. Input, answer and refusals: reference/broad_phase/all_pairs.h.
///
/// A radius is a root, rounded like any other: the ball of a node may not reach what it should hold, and solids that
/// touch at its end are lost (cause: rounding). In exact arithmetic the roots of which not all digits can be written
/// are rounded too, in the 9000th binary digit; otherwise it is right.
template <class Real>
std::vector<IndexPair> sphere_hierarchy(const std::vector<Sphere3<Real>>& spheres) {
  return pairs_in_hierarchy<Real>(spheres);
}
template <class Real>
std::vector<IndexPair> sphere_hierarchy(const std::vector<Aabb3<Real>>& boxes) {
  return pairs_in_hierarchy<Real>(boxes);
}

}  // namespace touchstone::reference
