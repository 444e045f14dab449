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

/// Bodies in a binary tree of boxes, so that a query looks at those that are near it.
class BodyTree {
 public:
  static constexpr std::size_t largest_leaf = 16;
  struct Node {
    std::size_t begin, end;                ///< places in the order
    std::size_t second;                    ///< the second child, the first is the next node; 0: a leaf
    std::optional<Aabb3<Rational>> box{};  ///< around the bodies that are there; none: there are none
  };

  /// Of at most `largest_leaf` bodies a single leaf, in the order of their indices; of others halves by their middles
  /// on the axis on which these extend farthest.
  explicit BodyTree(const Bodies& bodies);
  /// Some bodies have moved, gone or come since.
  void refit(const Bodies& bodies);

  const std::vector<Index>& order() const { return order_; }
  const std::vector<Node>& nodes() const { return nodes_; }     ///< in preorder; none of no bodies
  const std::vector<Index>& others() const { return others_; }  ///< bodies that came since
  /// `tree`: `order`, and of each node, in preorder, how many bodies its first child has, 0 of a leaf.
  Certificate certificate() const;

 private:
  struct Middle;
  void divide(std::vector<Middle>& middles, std::size_t begin, std::size_t end);

  std::vector<Index> order_, others_;
  std::set<Index> in_order_;
  std::vector<Node> nodes_;
};

}  // namespace touchstone::oracle
