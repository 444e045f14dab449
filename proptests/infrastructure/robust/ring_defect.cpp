// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "proptests/catch.h"
#include "proptests/long_rings.h"
#include "robust/lines/segment_segment.h"
#include "robust/rings/simple.h"

namespace touchstone::proptests::ring_defect_tests {
namespace {

using Found = std::pair<std::size_t, std::size_t>;

Found found_by(const std::optional<validation::RingDefect>& defect) {
  return defect ? Found{defect->first, defect->second} : Found{SIZE_MAX, SIZE_MAX};
}

/// By the definition of a RingDefect, pair after pair. No neighbours of these rings are the same point.
Found first_of_all_pairs(const Polygon2d& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      const auto common = robust::segment_segment_relation({ring[i], ring.next(i)}, {ring[j], ring.next(j)});
      if (common == SegmentRelation::overlap || (common == SegmentRelation::point && !neighbours)) return {i, j};
    }
  }
  return {SIZE_MAX, SIZE_MAX};
}

}  // namespace

TEST_CASE("ring_defect: the first defect that is named is the first of all pairs") {
  int defects = 0;
  for (std::size_t n = 4; n < 120; ++n) {
    for (const Polygon2d& ring : {random_ring(n), wavy_ring(n), comb(n, true), comb(n, false)}) {
      const Found right = first_of_all_pairs(ring);
      CAPTURE(n, right.first, right.second);
      CHECK(found_by(robust::ring_defect(ring)) == right);
      defects += right.first != SIZE_MAX;
      if (n < 10) continue;
      const Polygon2d spoilt = spoilt_at_the_end(ring);
      CHECK(found_by(robust::ring_defect(spoilt)) == first_of_all_pairs(spoilt));
    }
  }
  CHECK(defects > 100);
}

// Seconds; at a nanosecond for each pair of edges it would be a quarter of an hour, and its limit in ctest is a third
// of that (cmake/proptests.cmake).
TEST_CASE("ring_defect: the defect of a very long ring is named") {
  constexpr std::size_t n = 1'000'000;
  CHECK(robust::ring_defect(random_ring(n)));
  CHECK(robust::ring_defect(spoilt_at_the_end(wavy_ring(n))));
  CHECK(robust::ring_defect(spoilt_at_the_end(comb(n, true))));
  CHECK(robust::ring_defect(spoilt_at_the_end(comb(n, false))));
}

}  // namespace touchstone::proptests::ring_defect_tests
