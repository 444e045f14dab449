// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/answers.h"
#include "geometry/polygons.h"
#include "robust/kernel/filters/ordered_bits.h"

namespace touchstone::robust::structures {

/// A closed box in the plane, compared by the bits of its doubles.
struct PlaneBox {
  std::array<std::int64_t, 2> low, high;

  static PlaneBox around(const Point2d& p) {
    const std::array at{kernel::ordered_bits(p.x), kernel::ordered_bits(p.y)};
    return {at, at};
  }
  PlaneBox with(const PlaneBox& other) const {
    return {{std::min(low[0], other.low[0]), std::min(low[1], other.low[1])},
            {std::max(high[0], other.high[0]), std::max(high[1], other.high[1])}};
  }
  bool meets(const PlaneBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1];
  }
};

/// The boxes around parts of a ring, in a tree of eight children a node. The leaves are parts of sixteen edges in the
/// order of the ring, so that every node is one chain of edges.
///
/// A vertex belongs to the edge that ends there: a part is the edges that end at vertices `first` to `last` - 1, and
/// its chain begins at the vertex before `first`, round the ring.
class RingTree {
 public:
  struct Part {
    std::size_t first, last;
  };

  static constexpr std::size_t edges_of_a_part = 16;

  /// The ring has at least one vertex and is not closed by a repeated one.
  explicit RingTree(const Polygon2d& ring) : size_(ring.size()) {
    levels_.push_back(parents<edges_of_a_part>(size_, [&ring](std::size_t i) {
      return PlaneBox::around(ring.previous(i)).with(PlaneBox::around(ring[i]));
    }));
    while (levels_.back().size() > 1)
      levels_.push_back(parents<children>(levels_.back().size(), [this](std::size_t i) { return levels_.back()[i]; }));
  }

  /// The parity of the ray to +x from the point, or `boundary`. locate(part): `inside` if the ray crosses an odd number
  /// of the part's edges, `outside`, or `boundary`; an end on the ray's line counts as below it.
  ///
  /// Parts whose box contains the point are asked. A chain whose box the ray meets from outside has no point on the
  /// boundary, and its edges cross the ray an odd number of times exactly if its ends are on two sides of the ray's
  /// line.
  template <class Locate>
  Location located(const Polygon2d& ring, const Point2d& point, const Locate& locate) const {
    bool odd = false;
    const PlaneBox at = PlaneBox::around(point);
    return on_boundary(levels_.size() - 1, 0, ring, at, locate, odd) ? Location::boundary
           : odd                                                     ? Location::inside
                                                                     : Location::outside;
  }

  /// Returns whether `wanted` is true for a part here and one there whose boxes meet, and the box of the latter. Stops
  /// at the first.
  template <class Wanted>
  bool any_pair(const RingTree& other, const Wanted& wanted) const {
    return any_pair(levels_.size() - 1, 0, other, other.levels_.size() - 1, 0, wanted);
  }

 private:
  static constexpr std::size_t children = 8;

  /// The boxes around every so many of them.
  template <std::size_t together, class BoxAt>
  static std::vector<PlaneBox> parents(std::size_t count, const BoxAt& box_at) {
    std::vector<PlaneBox> found;
    found.reserve((count + together - 1) / together);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % together == 0) found.push_back(box_at(i));
      else found.back() = found.back().with(box_at(i));
    }
    return found;
  }

  Part part(std::size_t level, std::size_t i) const {
    std::size_t edges = edges_of_a_part;
    for (; level > 0; --level) edges *= children;
    return {edges * i, std::min(edges * (i + 1), size_)};
  }
  std::size_t last_child(std::size_t level, std::size_t i) const {
    return std::min(children * (i + 1), levels_[level - 1].size());
  }

  template <class Locate>
  bool on_boundary(std::size_t level, std::size_t i, const Polygon2d& ring, const PlaneBox& at, const Locate& locate,
                   bool& odd) const {
    const PlaneBox& box = levels_[level][i];
    if (at.low[1] < box.low[1] || at.low[1] > box.high[1] || at.low[0] > box.high[0]) return false;
    if (at.low[0] < box.low[0]) {
      const auto above = [&at](const Point2d& p) { return kernel::ordered_bits(p.y) > at.low[1]; };
      const auto [first, last] = part(level, i);
      odd ^= above(ring.previous(first)) != above(ring[last - 1]);
      return false;
    }
    if (level == 0) {
      const Location found = locate(part(level, i));
      odd ^= found == Location::inside;
      return found == Location::boundary;
    }
    for (std::size_t child = children * i; child < last_child(level, i); ++child)
      if (on_boundary(level - 1, child, ring, at, locate, odd)) return true;
    return false;
  }

  template <class Wanted>
  bool any_pair(std::size_t level, std::size_t i, const RingTree& other, std::size_t other_level, std::size_t j,
                const Wanted& wanted) const {
    const PlaneBox& there = other.levels_[other_level][j];
    if (!levels_[level][i].meets(there)) return false;
    if (level == 0 && other_level == 0) return wanted(part(level, i), other.part(other_level, j), there);
    if (level >= other_level) {
      for (std::size_t child = children * i; child < last_child(level, i); ++child)
        if (any_pair(level - 1, child, other, other_level, j, wanted)) return true;
    } else {
      for (std::size_t child = children * j; child < other.last_child(other_level, j); ++child)
        if (any_pair(level, i, other, other_level - 1, child, wanted)) return true;
    }
    return false;
  }

  std::size_t size_;
  std::vector<std::vector<PlaneBox>> levels_;
};

/// A ring with its tree.
struct TreedRing {
  explicit TreedRing(Polygon2d given) : ring(std::move(given)), tree(ring) {}
  Polygon2d ring;
  RingTree tree;
};

}  // namespace touchstone::robust::structures
