// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "reference/broad_phase/broad_phase.h"

namespace touchstone::reference {

/// A tree of boxes: each node encloses its bodies, which are split in half by the middles of their boxes along the
/// longest axis.
template <class Real>
class BoxHierarchy {
 public:
  explicit BoxHierarchy(IndexedBoxes<Real> bodies) {
    if (bodies.empty()) return;
    box_.push_back(around(bodies));
    if (bodies.size() == 1) {
      body_ = std::move(bodies);
      return;
    }
    const auto axis = longest_axis(box_[0]);
    std::stable_sort(bodies.begin(), bodies.end(), [axis](const IndexedBox<Real>& a, const IndexedBox<Real>& b) {
      return Real(a.box.min.*axis + a.box.max.*axis) < Real(b.box.min.*axis + b.box.max.*axis);
    });
    const auto half = bodies.begin() + static_cast<std::ptrdiff_t>(bodies.size() / 2);
    children_.emplace_back(IndexedBoxes<Real>(bodies.begin(), half));
    children_.emplace_back(IndexedBoxes<Real>(half, bodies.end()));
  }

  template <class Query, class Found, class See = Unseen>
  void search(const Query& query, const Found& found, const See& see = {}) const {
    if (box_.empty()) return;
    const bool entered = query.meets(box_[0]);
    see(*this, entered);
    if (!entered) return;
    for (const IndexedBox<Real>& body : body_) found(body);
    for (const BoxHierarchy& child : children_) child.search(query, found, see);
  }
  const Aabb3<Real>& volume() const { return box_[0]; }  ///< there is none without bodies
  const std::vector<BoxHierarchy>& children() const { return children_; }

 private:
  static Real Point3<Real>::*longest_axis(const Aabb3<Real>& box) {
    Real Point3<Real>::*longest = &Point3<Real>::x;
    for (Real Point3<Real>::*axis : {&Point3<Real>::y, &Point3<Real>::z})
      if (Real(box.max.*longest - box.min.*longest) < Real(box.max.*axis - box.min.*axis)) longest = axis;
    return longest;
  }

  std::vector<Aabb3<Real>> box_;  ///< one, unless there are no bodies
  IndexedBoxes<Real> body_;       ///< of a leaf
  std::vector<BoxHierarchy> children_;
};

/// Answers `broad_phase` by a bounding volume hierarchy of boxes.
///
/// Deck p. 58-61: whatever does not meet a node's volume meets nothing below it. Input, answer and refusals:
/// reference/broad_phase/broad_phase.h.
///
/// A node is compared and not computed with, and holds what is below it: boxes and points are answered right by the
/// double version. For a ray, the quotients of a node round no further in than those of what is in it: the double
/// version answers what `broad_phase` answers. In exact arithmetic it is right.
template <class Real>
Replies bounding_volume_hierarchy(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(InStructure<BoxHierarchy, Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
