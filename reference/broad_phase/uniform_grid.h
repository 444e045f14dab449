// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "reference/broad_phase/broad_phase.h"

namespace touchstone::reference {

/// The box around all bodies, cut into equal cells, on each axis as many, and about as many as bodies altogether. A
/// body is in each cell that it meets.
template <class Real>
class Grid {
 public:
  explicit Grid(const IndexedBoxes<Real>& bodies) {
    if (bodies.empty()) return;
    int count = 1;
    while (static_cast<std::size_t>(count * count * count) < bodies.size()) ++count;
    const Aabb3<Real> all = around(bodies);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j)
        for (int k = 0; k < count; ++k) add_cell(all, {i, j, k}, count, bodies);
  }

  /// A cell that has bodies.
  struct Cell {
    Aabb3<Real> box;
    IndexedBoxes<Real> bodies;
  };

  template <class Query, class Found, class See = Unseen>
  void search(const Query& query, const Found& found, const See& see = {}) const {
    for (const Cell& cell : cells_) {
      const bool entered = query.meets(cell.box);
      see(cell, entered);
      if (!entered) continue;
      for (const IndexedBox<Real>& body : cell.bodies) found(body);
    }
  }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  void add_cell(const Aabb3<Real>& all, const std::array<int, 3>& number, int count, const IndexedBoxes<Real>& bodies) {
    Aabb3<Real> cell;
    const auto cut = [&](Real Point3<Real>::*axis, int place) {
      const Real size = Real((all.max.*axis - all.min.*axis) / Real(count));
      cell.min.*axis = Real(all.min.*axis + Real(place) * size);
      cell.max.*axis = Real(all.min.*axis + Real(place + 1) * size);
    };
    cut(&Point3<Real>::x, number[0]), cut(&Point3<Real>::y, number[1]), cut(&Point3<Real>::z, number[2]);
    IndexedBoxes<Real> in;
    for (const IndexedBox<Real>& body : bodies)
      if (pair_meets(cell, body.box)) in.push_back(body);
    if (!in.empty()) cells_.push_back({cell, std::move(in)});
  }

  std::vector<Cell> cells_;
};

/// Answers `broad_phase` by a uniform grid.
///
/// Deck p. 62: only bodies of one cell are compared. Input, answer and refusals: reference/broad_phase/broad_phase.h.
///
/// Right in exact arithmetic. In binary64 the ends of cells round, and the last one may lie before the last body's:
/// a body there is in no cell. Where the extent of all bodies overflows, the cells have no ends that could be
/// compared, and all are lost (cause: rounding).
template <class Real>
Replies uniform_grid(const std::vector<Aabb3<Real>>& boxes, const std::vector<Command<Real>>& commands) {
  return replies(InStructure<Grid, Real>{}, boxes, commands);
}

}  // namespace touchstone::reference
