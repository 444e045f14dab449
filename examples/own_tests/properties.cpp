// SPDX-License-Identifier: Apache-2.0
// RapidCheck: my::meet against the truth, on questions that are degenerate on purpose.
#include <touchstone/robust/lines/segment_segment.h>
#include <touchstone/testing/laws.h>
#include <touchstone/testing/rapidcheck.h>

#include "meet.h"

using namespace touchstone;
using namespace touchstone::tests;

int main() {
  bool right = rc::check("segments meet where they have a common point", [] {
    const auto [a, b] = *questions<operations::segment_segment>();
    RC_ASSERT(my::meet(a, b) == (robust::segment_segment(a, b).relation != SegmentRelation::disjoint));
  });
  right &= rc::check("whether segments meet does not depend on their order, size and place", [] {
    const auto question = *questions<operations::segment_segment>();
    RC_ASSERT(broken_law(question, my::meet) == "");
  });
  return right ? 0 : 1;
}
