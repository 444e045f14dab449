// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// Trees of boxes, eight to a node, in which all pairs that meet are found eight at a time.
namespace touchstone::robust::batch::isa {

/// Eight boxes, by integers that keep the order of coordinates (`Coarse`): on each axis the eight lower ends, then the
/// complements of the eight upper ends, which are in the opposite order. A free place meets nothing: its integers are
/// the largest.
struct alignas(64) EightBoxes {
  static constexpr std::size_t places = 8;
  std::int32_t ends[3][2 * places];
};

/// The boxes of node k are those around nodes 8 k to 8 k + 7 of the level below; on level 0, the boxes 8 k to 8 k + 7.
/// The last level has one node.
struct EightTree {
  static constexpr std::size_t most_levels = 11;
  const EightBoxes* level[most_levels];
  std::size_t levels;
  const Index* body;  ///< the index of each box in the list, and anything in free places
};

/// A memory for pairs: `flush` makes room for as many as a leaf has with another.
struct PairSink {
  static constexpr std::size_t room = EightBoxes::places * EightBoxes::places + EightBoxes::places;
  IndexPair *next, *last;  ///< there is room while next <= last
  void (*flush)(PairSink&);
};

/// The parts of one search that several threads share: each comes to all parts, in the same order, and does the one
/// whose turn it took, then takes another.
class Turns {
 public:
  explicit Turns(std::atomic<std::size_t>& next) : next_(next), own_(next.fetch_add(1)) {}
  [[gnu::always_inline]] bool own() {
    if (seen_++ != own_) return false;
    own_ = next_.fetch_add(1);
    return true;
  }

 private:
  std::atomic<std::size_t>& next_;
  std::size_t own_, seen_ = 0;
};

/// Puts the pairs i < j of the boxes of two trees that meet, in any order; for one tree given twice, each pair once.
/// Where integers are equal, the doubles of the list `boxes` are compared; nullptr if the integers tell all apart.
/// `turns` is nullptr if it is alone.
using JoinPairs = void(const EightTree& one, const EightTree& other, const Aabb3d* boxes, PairSink& sink, Turns* turns);

}  // namespace touchstone::robust::batch::isa
