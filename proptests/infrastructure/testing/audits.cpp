// SPDX-License-Identifier: Apache-2.0
#include "proptests/catch.h"
#include "robust/lines/orientation.h"
#include "robust/lines/segment_segment.h"
#include "testing/audit.h"

/// An audit inside a test.
namespace touchstone::tests {
namespace {

struct Right {
  static constexpr const char* name = "right 1";
  static constexpr auto boundary = Boundary::closed;
  Side orientation(Point2d a, Point2d b, Point2d c) { return robust::orientation(a, b, c); }
  SegmentSegment<double> segment_segment(Segment2d a, Segment2d b) { return robust::segment_segment(a, b); }
};

/// Three ways to be wrong.
struct Wrong {
  static constexpr const char* name = "wrong 1";
  int asked = 0;
  Side orientation(Point2d, Point2d, Point2d) { return ++asked, Side::left; }
  bool point_in_polygon(const Polygon2d&, Point2d) { throw std::runtime_error("out of cheese"); }
  std::optional<bool> aabb_aabb(const Aabb2d&, const Aabb2d&) { return std::nullopt; }
};

}  // namespace

TEST_CASE("audit in process: a right engine has no findings, and every operation that it has was asked") {
  Right engine;
  const audit::Tally tally = audit(engine, {.cases = 500});
  CHECK(findings(tally) == "");
  CHECK_FALSE(tally.has_findings());
  REQUIRE(tally.operations.size() == 2);
  for (const auto& operation : tally.operations) {
    const audit::Cell total = operation.total();
    CHECK(total.cases() + total.refused == 500);
    CHECK(total.count(catalogue::Verdict::agree) == total.cases());
  }
}

TEST_CASE("audit in process: findings name operation, family, verdict, answer and the line that repeats them") {
  Wrong engine;
  const std::string said = findings(audit(engine, {.operations = {"orientation"}, .families = {"collinear"}}));
  CHECK(engine.asked > 2000);
  CHECK_THAT(said, StartsWith("orientation, collinear: "));
  CHECK_THAT(said, ContainsSubstring(
                       " of 2000 cases: truth on, answer left\n  it says {\"side\":\"left\"}\n  echo '{\"p0\":["));
  CHECK_THAT(said, EndsWith("' | touchstone ask orientation -\n"));
  const std::string thrown = findings(audit(engine, {.operations = {"point_in_polygon"}, .cases = 100}));
  CHECK_THAT(thrown, ContainsSubstring(": invalid in ") && ContainsSubstring(", answer no valid answer\n") &&
                         ContainsSubstring("\n  out of cheese\n"));
  const audit::Tally unsupported = audit(engine, {.operations = {"aabb_aabb"}, .cases = 100});
  CHECK(findings(unsupported) == "");
  const audit::Cell total = unsupported.operations[0].total();
  CHECK(total.count(catalogue::Verdict::unsupported) == total.cases());
  CHECK(total.cases() + total.refused + total.other_alternative == 100);
}

TEST_CASE("audit in process: the same options give the same findings, another seed others") {
  Wrong engine;
  const AuditOptions options{.operations = {"orientation"}, .cases = 300};
  AuditOptions other = options;
  other.seed = 2;
  CHECK(findings(audit(engine, options)) == findings(audit(engine, options)));
  CHECK(findings(audit(engine, options)) != findings(audit(engine, other)));
}

TEST_CASE("audit in process: what the engine or the catalogue has not is named") {
  Right engine;
  CHECK_THROWS_WITH(audit(engine, {.operations = {"ray_segment"}}), "operations: the engine has no ray_segment");
  CHECK_THROWS_WITH(audit(engine, {.operations = {"orientatoin"}}),
                    R"(operations: the engine has no orientatoin (did you mean "orientation"?))");
  CHECK_THROWS_WITH(audit(engine, {.families = {"collinaer"}}), "families: no operation asked has a family collinaer");
}

}  // namespace touchstone::tests
