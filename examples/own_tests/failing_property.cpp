// SPDX-License-Identifier: Apache-2.0
// A property that fails: what RapidCheck prints of my::meet_by_four_sides.
#include <touchstone/robust/lines/segment_segment.h>
#include <touchstone/testing/rapidcheck.h>

#include "meet.h"

using namespace touchstone;
using namespace touchstone::tests;

int main() {
  const bool right = rc::check("segments meet where they have a common point", [] {
    const auto [a, b] = *questions<operations::segment_segment>();
    RC_ASSERT(my::meet_by_four_sides(a, b) == (robust::segment_segment(a, b).relation != SegmentRelation::disjoint));
  });
  return right ? 0 : 1;
}
