// SPDX-License-Identifier: Apache-2.0
#include <touchstone/geometry/invalid_input.h>
#include <touchstone/oracle/lines/segment_segment.h>
#include <touchstone/reference/lines/segment_segment.h>
#include <touchstone/robust/lines/segment_segment.h>

#include <cstdio>
#include <limits>
#include <string>

using namespace touchstone;

/// The segments lie in one line and share [1, 2]: the textbook formula misses it, the two others do not.
int main() {
  const Segment2d a{{0, 0}, {2, 0}}, b{{1, 0}, {3, 0}};
  bool right = reference::segment_segment(a, b).relation == SegmentRelation::disjoint;
  right = right && robust::segment_segment(a, b).relation == SegmentRelation::overlap;
  right = right && oracle::segment_segment(a, b).answer.relation == SegmentRelation::overlap;
  if (!right) std::puts("a module answers otherwise than in its own build");

  bool refused = false;
  try {
    robust::segment_segment({{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}}, b);
  } catch (const InvalidInput& error) {
    refused = error.field() == "a[1][0]" && error.rule() == "finite number";
  }
  if (!refused) std::puts("NaN came through the door");
  return right && refused ? 0 : 1;
}
