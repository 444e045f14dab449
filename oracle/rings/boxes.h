// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/thin_shapes.h"
#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {

/// Consecutive edges of a ring, under boxes: each box contains a run of edges, and two halves of a run have boxes of
/// their own. Tests that the oracle defines for all edges run here for all except those that their box decides.
class Boxes {
 public:
  struct Box {
    const Integer *left, *right, *bottom, *top;  ///< coordinates of the edges, in their original order
  };

  /// At least one edge; they have to outlive this.
  explicit Boxes(const std::vector<Segment2<Integer>>& edges);

  static bool meet(const Box& a, const Box& b) {
    return *a.left <= *b.right && *b.left <= *a.right && *a.bottom <= *b.top && *b.bottom <= *a.top;
  }
  static Box box_of(const Segment2<Integer>& edge);

  /// Calls visit(i) for edges from `first` on, in ascending order, skipping boxes for which may(box) is false; until a
  /// visit returns true, which is then returned.
  template <class May, class Visit>
  bool ascending(std::size_t first, const May& may, const Visit& visit) const {
    return walk<true>(0, 0, edges_.size(), first, may, visit);
  }
  /// The same for all edges in descending order.
  template <class May, class Visit>
  bool descending(const May& may, const Visit& visit) const {
    return walk<false>(0, 0, edges_.size(), 0, may, visit);
  }

  /// Lessens `least` to the squared distance of the point from an edge i for which counts(i), if one is less.
  template <class Counts>
  void lessen(std::optional<SquaredLength<Integer>>& least, const Point2<Integer>& p, const Counts& counts) const {
    lessen(0, 0, edges_.size(), least, p, counts);
  }

 private:
  static std::size_t middle(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

  void build(std::size_t node, std::size_t first, std::size_t last);
  /// The distance of the box of a node from a point: no edge in it is nearer.
  Integer squared_distance_of(std::size_t node, const Point2<Integer>& p) const;

  template <bool upwards, class May, class Visit>
  bool walk(std::size_t node, std::size_t first, std::size_t last, std::size_t from, const May& may,
            const Visit& visit) const {
    if (last <= from || !may(boxes_[node])) return false;
    if (last - first == 1) return visit(first);
    const std::size_t between = middle(first, last);
    const auto low = [&] { return walk<upwards>(2 * node + 1, first, between, from, may, visit); };
    const auto high = [&] { return walk<upwards>(2 * node + 2, between, last, from, may, visit); };
    return upwards ? low() || high() : high() || low();
  }

  template <class Counts>
  void lessen(std::size_t node, std::size_t first, std::size_t last, std::optional<SquaredLength<Integer>>& least,
              const Point2<Integer>& p, const Counts& counts) const {
    if (last - first == 1) {
      if (!counts(first)) return;
      SquaredLength<Integer> distance = squared_distance(p, edges_[first], Extent::segment);
      if (!least || distance < *least) least = std::move(distance);
      return;
    }
    struct Half {
      Integer distance;
      std::size_t node, first, last;
    };
    const std::size_t between = middle(first, last);
    Half near{squared_distance_of(2 * node + 1, p), 2 * node + 1, first, between};
    Half far{squared_distance_of(2 * node + 2, p), 2 * node + 2, between, last};
    if (far.distance < near.distance) std::swap(near, far);
    for (const Half& half : {near, far}) {
      if (!least || half.distance * least->denominator < least->numerator)
        lessen(half.node, half.first, half.last, least, p, counts);
    }
  }

  const std::vector<Segment2<Integer>>& edges_;
  std::vector<Box> boxes_;
};

}  // namespace touchstone::oracle
