// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/simple.h"

#include <cstdint>

#include "oracle/exact/systems/elimination.h"
#include "oracle/rings/boxes.h"

namespace touchstone::oracle {
namespace {

using Word = std::int64_t;

SegmentRelation relation(const IntegerRing& ring, Index i, Index j) {
  if (ring.words.empty()) return segment_segment_relation<Integer>(ring.edge(i), ring.edge(j));
  const auto edge = [&](Index k) { return Segment2<Word>{ring.words[k], ring.words[ring.after(k)]}; };
  return segment_segment_relation<Int128>(edge(i), edge(j));
}

}  // namespace

std::optional<validation::RingDefect> ring_defect(const IntegerRing& ring) {
  const Index n = ring.size();
  for (Index i = 0; i < n; ++i) {
    if (ring[i] == ring[ring.after(i)]) return validation::RingDefect{i, i};
  }
  const std::vector<Segment2<Integer>> edges = ring.edges();
  const Boxes boxes(edges);
  std::optional<validation::RingDefect> first;
  for (Index i = 0; i + 1 < n && !first; ++i) {
    const Boxes::Box own = Boxes::box_of(edges[i]);
    const auto may_meet = [&own](const Boxes::Box& box) { return Boxes::meet(own, box); };
    boxes.ascending(i + 1, may_meet, [&](std::size_t j) {
      const bool neighbours = j == i + 1u || (i == 0 && j == n - 1u);
      const SegmentRelation found = relation(ring, i, static_cast<Index>(j));
      if (found == SegmentRelation::overlap || (found == SegmentRelation::point && !neighbours))
        first = validation::RingDefect{i, j};
      return first.has_value();
    });
  }
  return first;
}

}  // namespace touchstone::oracle
