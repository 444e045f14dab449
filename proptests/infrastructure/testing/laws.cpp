// SPDX-License-Identifier: Apache-2.0
#include "testing/laws.h"

#include "proptests/catch.h"
#include "robust/lines/orientation.h"
#include "robust/lines/segment_segment.h"

/// The symmetries of an operation, asked of users' functions.
namespace touchstone::tests {
namespace {

using Orientation = operations::orientation;

template <class Mine>
std::string first_broken(const Mine& mine) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto question = asked<Orientation>(families_named(operation_of<Orientation>(), {"grid", "random"}), seed);
    const std::string broken = broken_law(question, mine);
    if (!broken.empty()) return broken;
  }
  return "";
}

}  // namespace

TEST_CASE("laws: what breaks one is named, and robust breaks none") {
  CHECK(first_broken([](Point2d a, Point2d b, Point2d c) { return robust::orientation(a, b, c); }) == "");
  // A tolerance has a size.
  CHECK(first_broken([](Point2d a, Point2d b, Point2d c) {
          const double s = cross(b - a, c - a);
          return s > 1e-6 ? Side::left : s < -1e-6 ? Side::right : Side::on;
        }) == "times a power of two");
  // Above the line, which is left of it only where it runs to the right.
  CHECK(first_broken([](Point2d a, Point2d, Point2d c) {
          return c.y > a.y ? Side::left : c.y < a.y ? Side::right : Side::on;
        }) == "a symmetry of the axes");
  const auto segments = asked<operations::segment_segment>(
      families_named(operation_of<operations::segment_segment>(), {"zero_length"}), 4);
  CHECK(broken_law(segments, [](const Segment2d& a, const Segment2d& b) {
          return robust::segment_segment(a, b).relation;
        }) == "");
  CHECK(broken_law(
            segments, [](const Segment2d& a, const Segment2d& b) { return robust::segment_segment(a, b); },
            Compared::everything) == "");
  CHECK(broken_law(segments, [&](const Segment2d& a, const Segment2d&) {
          return catalogue::packed(a) == catalogue::packed(std::get<0>(segments));
        }) == "arguments exchanged");
}

}  // namespace touchstone::tests
