// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// A hierarchy of spheres (deck p. 58-61) over balls that do not change: each node is a ball that contains both of its
/// children, exactly, because its radius is rounded up; an infinite one contains everything. Balls that are not valid
/// throw InvalidInput ("spheres[i].radius", "radius >= 0" ...).
///
/// Right for all finite doubles in every floating-point environment: like balls, nodes are tested exactly for whether
/// they meet.
class BallTree {
 public:
  explicit BallTree(const std::vector<Sphere3d>& spheres);

  /// The pairs of indices i < j of balls that meet, sorted.
  std::vector<IndexPair> pairs() const;

  /// A node has two children, or is a copy of one ball of the list.
  struct Node {
    Sphere3d ball;
    Index left = 0, right = 0;
    bool leaf = true;
    Index place = 0;
  };
  /// The last one is the root.
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Index made(std::vector<Index>& order, std::size_t first, std::size_t last, const std::vector<Sphere3d>& spheres);

  std::vector<Node> nodes_;
};

}  // namespace touchstone::robust
