// SPDX-License-Identifier: Apache-2.0
// Catch2 alone: laws that are shrunk where they fail, generators, and a whole audit inside a test.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#endif
#include <touchstone/robust/lines/segment_segment.h>
#include <touchstone/testing/audit.h>
#include <touchstone/testing/catch2.h>

#include "meet.h"

using namespace touchstone;
using namespace touchstone::tests;

namespace {

bool have_a_common_point(const Segment2d& a, const Segment2d& b) {
  return robust::segment_segment(a, b).relation != SegmentRelation::disjoint;
}

struct MyEngine {
  static constexpr const char* name = "my engine 1.0";
  static constexpr auto boundary = Boundary::closed;
  bool segment_segment(Segment2d a, Segment2d b) { return my::meet(a, b); }
};

}  // namespace

TEST_CASE("segments meet where they have a common point") {
  always<operations::segment_segment>(
      [](const Segment2d& a, const Segment2d& b) { return my::meet(a, b) == have_a_common_point(a, b); });
}

TEST_CASE("segments that share an end meet") {
  const auto [a, b] = GENERATE(take(100, drawn<operations::segment_segment>({.families = {"shared_end"}})));
  CAPTURE(a, b);
  CHECK(my::meet(a, b));
}

TEST_CASE("an audit finds nothing") {
  MyEngine engine;
  CHECK(findings(tests::audit(engine, {.cases = 2000})) == "");
}
