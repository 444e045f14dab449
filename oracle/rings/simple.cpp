// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/simple.h"

#include "oracle/exact/elimination.h"
#include "oracle/lines/segment_segment.h"

namespace touchstone::oracle {
namespace {

SegmentRelation relation(const Segment2d& a, const Segment2d& b) { return segment_segment_relation(a, b); }
SegmentRelation relation(const Segment2<Rational>& a, const Segment2<Rational>& b) {
  return segment_segment_relation<Rational>(a, b);
}

template <class Number>
std::optional<door::RingDefect> first_defect(const Polygon2<Number>& ring) {
  const std::size_t n = ring.size();
  const auto edge = [&](std::size_t i) { return Segment2<Number>{ring[i], ring.next(i)}; };
  for (std::size_t i = 0; i < n; ++i) {
    if (ring[i] == ring.next(i)) return door::RingDefect{i, i};
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const SegmentRelation found = relation(edge(i), edge(j));
      if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours)) return door::RingDefect{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<door::RingDefect> ring_defect(const Polygon2d& ring) { return first_defect(ring); }
std::optional<door::RingDefect> ring_defect(const Polygon2<Rational>& ring) { return first_defect(ring); }

}  // namespace touchstone::oracle
