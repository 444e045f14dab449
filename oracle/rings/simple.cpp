// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/simple.h"

#include <cstdint>

#include "oracle/exact/elimination.h"

namespace touchstone::oracle {
namespace {

using Word = std::int64_t;

SegmentRelation relation(const WholeRing& ring, Index i, Index j) {
  if (!ring.words.empty()) {
    const auto edge = [&](Index k) { return Segment2<Word>{ring.words[k], ring.words[ring.after(k)]}; };
    return segment_segment_relation<Int128>(edge(i), edge(j));
  }
  const Segment2<Integer> a = ring.edge(i), b = ring.edge(j);
  return boxes_apart(a, b) ? SegmentRelation::disjoint : segment_segment_relation<Integer>(a, b);
}

}  // namespace

std::optional<validation::RingDefect> ring_defect(const WholeRing& ring) {
  const Index n = ring.size();
  for (Index i = 0; i < n; ++i) {
    if (ring[i] == ring[ring.after(i)]) return validation::RingDefect{i, i};
  }
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const SegmentRelation found = relation(ring, i, j);
      if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours))
        return validation::RingDefect{i, j};
    }
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle
