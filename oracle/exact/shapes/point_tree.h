// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/shapes/whole_cloud.h"

namespace touchstone::oracle {

/// Some points of a cloud, which must outlive it, in a binary tree of boxes, to look for one beyond a plane: half of a
/// box's points are in either child.
class PointTree {
 public:
  PointTree(const IntegerCloud& cloud, std::vector<Index> points);
  /// True if a point p has normal . p > level.
  bool any_beyond(const SupportingPlane& plane) const { return any_beyond(plane, 0); }

 private:
  struct Node {
    std::size_t begin, end;  ///< of its points
    std::size_t second = 0;  ///< the second child, the first is the next node; 0: a leaf
    Point3<Integer> low, high;
  };
  void divide(std::size_t begin, std::size_t end);
  bool any_beyond(const SupportingPlane& plane, std::size_t place) const;

  const IntegerCloud& cloud_;
  std::vector<Index> points_;
  std::vector<Node> nodes_;  ///< in preorder
};

}  // namespace touchstone::oracle
