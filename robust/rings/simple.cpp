// SPDX-License-Identifier: Apache-2.0
#include "robust/rings/simple.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "robust/kernel/control_word.h"
#include "robust/lines/segment_segment.h"
#include "robust/rings/sweep.h"

namespace touchstone::robust {
namespace {

struct Box {
  double left, right, bottom, top;
};

Box box_of(const Segment2d& s) {
  const auto [left, right] = std::minmax(s.a.x, s.b.x);
  const auto [bottom, top] = std::minmax(s.a.y, s.b.y);
  return {left, right, bottom, top};
}

/// Every pair of edges whose boxes meet, for the first defect of all.
class Pairs {
 public:
  explicit Pairs(const Polygon2d& ring) : ring_(ring), order_(ring.size()) {
    boxes_.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) boxes_.push_back(box_of(edge(i)));
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t i, std::size_t j) { return boxes_[i].left < boxes_[j].left; });
  }

  std::optional<validation::RingDefect> first_defect() {
    std::vector<std::size_t> active;
    for (const std::size_t i : order_) {
      std::erase_if(active, [&](std::size_t j) { return boxes_[j].right < boxes_[i].left; });
      for (const std::size_t j : active) compare(std::min(i, j), std::max(i, j));
      active.push_back(i);
    }
    return first_;
  }

 private:
  Segment2d edge(std::size_t i) const { return {ring_[i], ring_.next(i)}; }

  void compare(std::size_t i, std::size_t j) {
    if (boxes_[i].top < boxes_[j].bottom || boxes_[j].top < boxes_[i].bottom) return;
    if (first_ && std::pair(first_->first, first_->second) < std::pair(i, j)) return;
    const bool neighbours = j == i + 1 || (i == 0 && j == ring_.size() - 1);
    const SegmentRelation found = segment_segment_relation(edge(i), edge(j));
    if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours)) first_ = {i, j};
  }

  const Polygon2d& ring_;
  std::vector<Box> boxes_;
  std::vector<std::size_t> order_;
  std::optional<validation::RingDefect> first_;
};

}  // namespace

std::optional<validation::RingDefect> ring_defect(const Polygon2d& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (validation::same(ring[i].x, ring.next(i).x) && validation::same(ring[i].y, ring.next(i).y))
      return validation::RingDefect{i, i};
  }
  const kernel::ControlWord ieee;  // comparisons: flushed denormals would all be 0
  if (simple_by_sweep(ring)) return std::nullopt;
  return Pairs(ring).first_defect();
}

}  // namespace touchstone::robust
