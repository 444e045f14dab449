// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

/// Where a tree over boxes is cut. All estimates, in single precision: no answer depends on them. In scope of a guard.
class PairCut {
 public:
  PairCut() = default;
  explicit PairCut(const std::vector<Aabb3d>& boxes);

  /// Parts the boxes at the places from `begin` to before `end`, more than one, and returns where the second part
  /// begins: large boxes go apart from small ones where they are in the way on every axis; else the middle of the axis
  /// that is longest for the widest box; else one half.
  Index operator()(Index begin, Index end);

  Index body(Index place) const { return items_[place].body; }
  std::vector<Index> order() const;
  /// Of all coordinates of middles the one next to 0: what is far away from 0 as a whole is seen from there.
  std::array<double, 3> origin() const { return origin_; }
  /// The greatest width of a box, for the spread of all middles on its axis.
  double size(const Aabb3d& box) const;

 private:
  struct alignas(16) Item {
    std::array<float, 3> middle;
    Index body;
    std::array<float, 3> width;
    float unused;
  };
  /// Of some items: the spread of their middles, and their widths, on each axis.
  struct Spread {
    std::array<float, 4> low, high, least, most;
    float extent(std::size_t axis) const { return high[axis] - low[axis]; }
  };

  void place_in_frame(Index begin, Index end);
  Spread spread_of(Index begin, Index end) const;
  template <class Before>
  Index parted(Index begin, Index end, const Before& before);

  const std::vector<Aabb3d>* boxes_ = nullptr;
  std::vector<Item> items_;
  std::array<double, 3> origin_{}, scale_{1, 1, 1};
};

}  // namespace touchstone::robust::structures
