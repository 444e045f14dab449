// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

/// Chooses where a tree over boxes is split. All of it is estimated, in single precision: no answer depends on it.
/// Requires a guard in scope.
class PairCut {
 public:
  PairCut() = default;
  explicit PairCut(const std::vector<Aabb3d>& boxes);

  /// Partitions the boxes at the indices from `begin` to before `end`, more than one, and returns where the second part
  /// begins: large boxes are separated from small ones if they are in the way on every axis; otherwise the split is at
  /// the middle of the axis that is longest for the widest box; otherwise in half.
  Index operator()(Index begin, Index end);

  Index body(Index place) const { return items_[place].body; }
  std::vector<Index> order() const;
  /// The coordinate of a middle that is nearest to 0, on each axis: coordinates that are all far from 0 are measured
  /// from there.
  std::array<double, 3> origin() const { return origin_; }
  /// The greatest width of a box, relative to the spread of all middles on its axis.
  double size(const Aabb3d& box) const;

 private:
  struct alignas(16) Item {
    std::array<float, 3> middle;
    Index body;
    std::array<float, 3> width;
    float unused;
  };
  /// The spread of the middles of some boxes, and their widths, on each axis.
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
