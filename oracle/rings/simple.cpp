// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/simple.h"

#include <algorithm>
#include <cstdint>

#include "oracle/exact/elimination.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

using Word = std::int64_t;

/// By comparing alone, which is had much faster of long integers: one edge is left of the other, or below it.
bool boxes_apart(const Segment2<Integer>& a, const Segment2<Integer>& b) {
  const auto before = [](const Integer& p, const Integer& q, const Integer& r, const Integer& s) {
    return std::max(p, q) < std::min(r, s);
  };
  return before(a.a.x, a.b.x, b.a.x, b.b.x) || before(b.a.x, b.b.x, a.a.x, a.b.x) || before(a.a.y, a.b.y, b.a.y, b.b.y) ||
         before(b.a.y, b.b.y, a.a.y, a.b.y);
}

SegmentRelation relation(const WholeRing& ring, Index i, Index j) {
  if (!ring.words.empty()) {
    const auto edge = [&](Index k) { return Segment2<Word>{ring.words[k], ring.words[ring.after(k)]}; };
    return segment_segment_relation<Int128>(edge(i), edge(j));
  }
  const Segment2<Integer> a = ring.edge(i), b = ring.edge(j);
  return boxes_apart(a, b) ? SegmentRelation::disjoint : segment_segment_relation<Integer>(a, b);
}

std::optional<door::RingDefect> first_defect(const WholeRing& ring) {
  const Index n = ring.size();
  for (Index i = 0; i < n; ++i) {
    if (ring[i] == ring[ring.after(i)]) return door::RingDefect{i, i};
  }
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const SegmentRelation found = relation(ring, i, j);
      if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours)) return door::RingDefect{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<door::RingDefect> ring_defect(const Polygon2d& ring) { return first_defect(WholeRing(ring)); }
std::optional<door::RingDefect> ring_defect(const Polygon2<Rational>& ring) { return first_defect(WholeRing(ring)); }

}  // namespace touchstone::oracle
