// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

inline constexpr std::array axes_of_boxes{&Point3<Rational>::x, &Point3<Rational>::y, &Point3<Rational>::z};

/// Boxes of bodies by their indices.
using Bodies = std::map<Index, Aabb3<Rational>>;

/// Bodies in a binary tree of boxes, so that a query examines only those near it.
class BodyTree {
 public:
  static constexpr std::size_t largest_leaf = 16;
  struct Node {
    std::size_t begin, end;                ///< indices in the order
    std::size_t second;                    ///< the second child, the first is the next node; 0: a leaf
    std::optional<Aabb3<Rational>> box{};  ///< around the existing bodies; none: there are none
  };

  /// At most `largest_leaf` bodies form a single leaf, in the order of their indices; more are split in half by their
  /// middles on the axis on which these extend farthest.
  explicit BodyTree(const Bodies& bodies);
  /// Updates the tree after bodies have moved, or were removed or added.
  void refit(const Bodies& bodies);

  const std::vector<Index>& order() const { return order_; }
  const std::vector<Node>& nodes() const { return nodes_; }     ///< in preorder; empty without bodies
  const std::vector<Index>& others() const { return others_; }  ///< bodies added since
  /// `tree`: `order`, and for each node, in preorder, the number of bodies of its first child, 0 for a leaf.
  Certificate certificate() const;

 private:
  struct Middle;
  void divide(std::vector<Middle>& middles, std::size_t begin, std::size_t end);

  std::vector<Index> order_, others_;
  std::set<Index> in_order_;
  std::vector<Node> nodes_;
};

}  // namespace touchstone::oracle
