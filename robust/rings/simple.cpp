// SPDX-License-Identifier: Apache-2.0
#include "robust/rings/simple.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "robust/kernel/filters/control_word.h"
#include "robust/lines/segment_segment.h"
#include "robust/rings/sweep.h"

namespace touchstone::robust {
namespace {

struct Interval {
  double low, high;
};

Interval interval_of(double a, double b) { return a < b ? Interval{a, b} : Interval{b, a}; }

/// Edges in the order in which a line sweeping along one axis meets them, with their intervals on both axes.
struct Order {
  Order(std::vector<Interval> on_axis, std::vector<Interval> across_it)
      : along(std::move(on_axis)), across(std::move(across_it)), edges(along.size()) {
    std::iota(edges.begin(), edges.end(), std::size_t{0});
    std::sort(edges.begin(), edges.end(), [&](std::size_t i, std::size_t j) { return along[i].low < along[j].low; });
  }

  /// The number of pairs that overlap on the axis.
  std::size_t pairs() const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const auto beyond = std::upper_bound(edges.begin(), edges.end(), along[edges[k]].high,
                                           [&](double high, std::size_t i) { return high < along[i].low; });
      count += static_cast<std::size_t>(beyond - edges.begin()) - k - 1;
    }
    return count;
  }

  std::vector<Interval> along, across;
  std::vector<std::size_t> edges;
};

/// The order along whichever axis has fewer pairs.
Order order_of(const Polygon2d& ring) {
  std::vector<Interval> x, y;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    x.push_back(interval_of(ring[i].x, ring.next(i).x));
    y.push_back(interval_of(ring[i].y, ring.next(i).y));
  }
  Order by_x(x, y), by_y(std::move(y), std::move(x));
  return by_x.pairs() <= by_y.pairs() ? std::move(by_x) : std::move(by_y);
}

/// Pairs of edges whose boxes meet, for the first defect. Once a defect whose first edge is f is known, pairs of later
/// edges no longer matter: so later edges are kept apart and compared only with edges up to f.
class Pairs {
 public:
  explicit Pairs(const Polygon2d& ring) : ring_(ring), order_(order_of(ring)) {}

  std::optional<validation::RingDefect> first_defect() {
    for (const std::size_t i : order_.edges) {
      compare_with(early_, i);
      if (!late(i)) compare_with(late_, i);
      (late(i) ? late_ : early_).push_back(i);
    }
    return first_;
  }

 private:
  Segment2d edge(std::size_t i) const { return {ring_[i], ring_.next(i)}; }
  bool late(std::size_t i) const { return first_ && i > first_->first; }

  void compare_with(std::vector<std::size_t>& others, std::size_t i) {
    std::erase_if(others, [&](std::size_t j) { return order_.along[j].high < order_.along[i].low; });
    const auto before = first_;
    for (const std::size_t j : others) compare(std::min(i, j), std::max(i, j));
    if (!first_ || (before && before->first == first_->first)) return;
    const auto moved = std::stable_partition(early_.begin(), early_.end(), [this](std::size_t j) { return !late(j); });
    late_.insert(late_.end(), moved, early_.end());
    early_.erase(moved, early_.end());
  }

  void compare(std::size_t i, std::size_t j) {
    const Interval &a = order_.across[i], &b = order_.across[j];
    if (a.high < b.low || b.high < a.low) return;
    if (first_ && std::pair(first_->first, first_->second) < std::pair(i, j)) return;
    const bool neighbours = j == i + 1 || (i == 0 && j == ring_.size() - 1);
    const SegmentRelation found = segment_segment_relation(edge(i), edge(j));
    if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours)) first_ = {i, j};
  }

  const Polygon2d& ring_;
  Order order_;
  std::vector<std::size_t> early_, late_;
  std::optional<validation::RingDefect> first_;
};

}  // namespace

std::optional<validation::RingDefect> ring_defect(const Polygon2d& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (validation::same_position(ring[i], ring.next(i))) return validation::RingDefect{i, i};
  }
  const kernel::ControlWord ieee;  // comparisons: flushed denormals would all be 0
  if (simple_by_sweep(ring)) return std::nullopt;
  return Pairs(ring).first_defect();
}

}  // namespace touchstone::robust
