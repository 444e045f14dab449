// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "reference/broad_phase/broad_phase.h"

namespace touchstone::reference {

/// A cell, which is halved on each of its axes while it has more than two bodies, four times at most. A body is in each
/// cell that it meets.
template <class Real, bool in_space>
class CellTree {
 public:
  explicit CellTree(IndexedBoxes<Real> bodies) {
    if (bodies.empty()) return;
    const Aabb3<Real> all = around(bodies);
    *this = CellTree(all, std::move(bodies), 4);
  }

  template <class Query, class Found, class See = Unseen>
  void search(const Query& query, const Found& found, const See& see = {}) const {
    if (bodies_.empty() && children_.empty()) return;
    const bool entered = query.meets(cell_);
    see(*this, entered);
    if (!entered) return;
    for (const IndexedBox<Real>& body : bodies_) found(body);
    for (const CellTree& child : children_) child.search(query, found, see);
  }
  const Aabb3<Real>& volume() const { return cell_; }
  const std::vector<CellTree>& children() const { return children_; }

 private:
  CellTree(const Aabb3<Real>& cell, IndexedBoxes<Real> bodies, int depth) : cell_(cell) {
    if (bodies.size() <= 2 || depth == 0) {
      bodies_ = std::move(bodies);
      return;
    }
    std::vector<Aabb3<Real>> parts{cell};
    halve(parts, &Point3<Real>::x), halve(parts, &Point3<Real>::y);
    if constexpr (in_space) halve(parts, &Point3<Real>::z);
    for (const Aabb3<Real>& part : parts) {
      IndexedBoxes<Real> in;
      for (const IndexedBox<Real>& body : bodies)
        if (pair_meets(part, body.box)) in.push_back(body);
      if (!in.empty()) children_.push_back(CellTree(part, std::move(in), depth - 1));
    }
  }

  static void halve(std::vector<Aabb3<Real>>& parts, Real Point3<Real>::*axis) {
    const std::size_t count = parts.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Real middle = Real((parts[i].min.*axis + parts[i].max.*axis) / Real(2));
      parts.push_back(parts[i]);
      parts[i].max.*axis = middle, parts.back().min.*axis = middle;
    }
  }

  Aabb3<Real> cell_{};
  IndexedBoxes<Real> bodies_;
  std::vector<CellTree> children_;
};

template <class Real>
using Quadtree = CellTree<Real, false>;

/// Answers `broad_phase` by a quadtree over x and y; a cell is as high as all bodies.
///
/// Deck p. 62: a cell with many bodies is cut into four. Input, answer and refusals:
/// reference/broad_phase/broad_phase.h.
///
/// Right in exact arithmetic. Two cells end in one number, however it was rounded, and bodies and queries are compared
/// with it: boxes and points are answered right by the double version, unless a middle overflows and a cell begins
/// beyond the range. For a ray, both cells of a body may be missed where it passes between them and its parameters
/// round (cause: rounding).
template <class Real>
Replies quadtree(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(InStructure<Quadtree, Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
