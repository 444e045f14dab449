// SPDX-License-Identifier: Apache-2.0
#include "testing/asked.h"

#include <cmath>
#include <set>

#include "proptests/catch.h"
#include "robust/lines/orientation.h"
#include "robust/lines/segment_segment.h"
#include "robust/polygons/point_in_polygon.h"
#include "testing/catch2.h"
#include "testing/fuzzed_data.h"
#include "testing/rapidcheck.h"

/// Questions in users' own tests: drawn, shrunk, read from bytes, printed.
namespace touchstone::tests {

using Orientation = operations::orientation;
using Balls = operations::sphere_sphere;

TEST_CASE("asked: a question is its arguments, and says where it comes from") {
  const auto question = asked<Orientation>(families_named(operation_of<Orientation>(), {"collinear"}), 7);
  const auto [p0, p1, p] = question;
  static_assert(std::is_same_v<decltype(p0), const Point2d>);
  CHECK(question.family() == "collinear");
  CHECK(catalogue::packed(question.arguments()) == question.drawn.question);
  CHECK(std::apply([](Point2d a, Point2d b, Point2d c) { return robust::orientation(a, b, c); }, question) == Side::on);
  CHECK(replayed(*question.drawn.operation, question.drawn.family, question.drawn.draws).question ==
        question.drawn.question);
}

TEST_CASE("asked: questions are within the contract, of the families named, and the same for the same seed") {
  const Operation& angles = operation_of<operations::interior_angles>();
  const auto families = families_named(angles, {"grid", "any_bits"});
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto question = asked<operations::interior_angles>(families, seed);
    CHECK_NOTHROW(angles.examine(question.drawn.question));
    CHECK(asked<operations::interior_angles>(families, seed).drawn.question == question.drawn.question);
    seen.insert(question.family());
  }
  CHECK(seen == std::set<std::string>{"any_bits", "grid"});
}

TEST_CASE("asked: a family that the operation has not is named") {
  CHECK_THROWS_WITH(counterexample<Orientation>([](auto...) { return true; }, {.families = {"collinaer"}}),
                    R"(families: orientation has no family collinaer (did you mean "collinear"?))");
}

TEST_CASE("asked: one alternative alone, or all as a variant") {
  const auto all = families_named(operation_of<Balls>(), {});
  bool in_plane = false;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const auto [a, b] = asked<Balls, Sphere3d, Sphere3d>(all, seed);
    static_assert(std::is_same_v<decltype(b), const Sphere3d>);
    in_plane = in_plane || std::holds_alternative<Balls::InPlane>(asked<Balls>(all, seed).arguments());
  }
  CHECK(in_plane);
}

TEST_CASE("asked: questions of ordinary size have no number beyond 2^100, nor below 2^-100 but 0") {
  const auto is_ordinary = [](Point2d p) {
    for (const double number : {p.x, p.y}) {
      if (number != 0 && !(std::fabs(number) >= 0x1p-100 && std::fabs(number) <= 0x1p100)) return false;
    }
    return true;
  };
  const auto all_are = [&](Point2d a, Point2d b, Point2d c) {
    return is_ordinary(a) && is_ordinary(b) && is_ordinary(c);
  };
  CHECK(counterexample<Orientation>(all_are));
  CHECK_FALSE(counterexample<Orientation>(all_are, {.sizes = Sizes::ordinary}));
  const auto large = counterexample<Orientation>([](Point2d a, Point2d, Point2d) { return std::fabs(a.x) < 1e20; },
                                                 {.cases = 5000, .sizes = Sizes::ordinary});
  REQUIRE(large);
  CHECK(std::apply(all_are, large->arguments()));
}

TEST_CASE("asked: a law that fails gives the simplest question of its family") {
  // On the grid a number is a choice below 4, 0 being the simplest.
  const auto found = counterexample<Orientation>([](Point2d p0, Point2d, Point2d) { return p0.x < 2; },
                                                 {.families = {"grid"}, .cases = 5000});
  REQUIRE(found);
  const auto& [p0, p1, p] = *found;
  CHECK(p0 == Point2d{2, 0});
  CHECK(p1 == Point2d{0, 0});
  CHECK(p == Point2d{0, 0});
  CHECK(shown(*found) ==
        "orientation, family grid\n{\"p0\":[2,0],\"p1\":[0,0],\"p\":[0,0]}\n"
        "{\"p0\":[\"0x1p+1\",\"0x0p+0\"],\"p1\":[\"0x0p+0\",\"0x0p+0\"],\"p\":[\"0x0p+0\",\"0x0p+0\"]}\n"
        "echo '{\"p0\":[\"0x1p+1\",\"0x0p+0\"],\"p1\":[\"0x0p+0\",\"0x0p+0\"],\"p\":[\"0x0p+0\",\"0x0p+0\"]}' | "
        "touchstone ask orientation -");
}

TEST_CASE("asked: an exception is a failure, and a law that holds has no counterexample") {
  const auto thrower = [](Point2d p0, Point2d, Point2d) -> bool {
    if (p0.y != 0) throw std::runtime_error("not flat");
    return true;
  };
  const auto found = counterexample<Orientation>(thrower, {.families = {"grid"}});
  REQUIRE(found);
  CHECK(std::get<0>(*found) == Point2d{0, 1});
  CHECK_FALSE(counterexample<Orientation>([](auto...) { return true; }));
}

TEST_CASE("asked: what shrinks stays in its family and within the contract") {
  const auto found = counterexample<operations::point_in_polygon>(
      [](const Polygon2d& polygon, Point2d) { return polygon.vertices.size() < 4; }, {.families = {"on_edge"}});
  REQUIRE(found);
  CHECK(std::get<0>(*found).vertices.size() == 4);
  CHECK(robust::point_in_polygon(std::get<0>(*found), std::get<1>(*found)) == Location::boundary);
}

TEST_CASE("catch2: the generator gives the questions that always asks, and values print themselves") {
  std::vector<std::string> by_law, by_generator;
  always<Orientation>(
      [&](const Asked<Orientation>& question) {
        by_law.push_back(shown(question));
        return true;
      },
      {.cases = 20, .seed = 3});
  auto generator = drawn<Orientation>({.seed = 3});
  for (int i = 0; i < 20; ++i, generator.next()) by_generator.push_back(shown(generator.get()));
  CHECK(by_law == by_generator);
  CHECK(Catch::StringMaker<Segment2d>::convert({{0.1, 0}, {-2, 1e300}}) == "[[0.1,0],[-2,1e+300]]");
  CHECK(Catch::StringMaker<Side>::convert(Side::right) == "right");
  CHECK(Catch::StringMaker<Contact>::convert(Contact::touching) == "touching");
  CHECK(Catch::StringMaker<Asked<Orientation>>::convert(generator.get()) == shown(generator.get()));
}

TEST_CASE("fuzzed_data: bytes are questions, one after the other; past their end all is simplest") {
  const Operation& operation = operation_of<Orientation>();
  const std::uint8_t bytes[] = {1, 7, 3, 9, 200, 14, 5, 77, 31, 8, 2, 250, 6, 1, 0, 4, 19, 3, 8, 66, 2, 1, 9, 40};
  FuzzedData data(bytes, sizeof bytes);
  DrawStream same = DrawStream::replayed(bytes);
  for (int i = 0; i < 3; ++i) {
    const std::size_t family = same.below(operation.families().size());
    const catalogue::Question expected = operation.draw(same, family);
    const auto question = data.question<Orientation>();
    REQUIRE(question);
    CHECK(question->family() == operation.families()[family]);
    CHECK(question->drawn.question == expected);
  }
  CHECK(data.below(10) == same.below(10));
  FuzzedData nothing(nullptr, 0);
  const auto question = nothing.question<Orientation>();
  REQUIRE(question);
  CHECK(question->drawn.family == 0);
}

TEST_CASE("fuzzed_data: a question outside the contract is none") {
  const Operation& operation = operation_of<operations::interior_angles>();
  std::size_t none = 0;
  for (unsigned i = 0; i < 256; ++i) {
    const std::uint8_t bytes[] = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i * 7), 3, 1, 2, 5, 1, 1, 0};
    FuzzedData data(bytes, sizeof bytes);
    DrawStream same = DrawStream::replayed(bytes);
    const std::size_t family = same.below(operation.families().size());
    const Drawn drawn{&operation, family, {}, operation.draw(same, family)};
    const auto question = data.question<operations::interior_angles>();
    CHECK(question.has_value() == is_valid(drawn));
    none += question ? 0 : 1;
  }
  CHECK(none > 0);
}

TEST_CASE("rapidcheck: a property that fails shows the simplest question and the command that asks it") {
  using namespace rc::detail;
  const auto property = toProperty([] {
    const auto [p0, p1, p] = *questions<Orientation>({"grid"});
    RC_ASSERT(p0.x < 2);
  });
  TestParams parameters;
  parameters.seed = 1;
  parameters.maxSuccess = 2000;
  struct Silent : TestListener {
    void onTestCaseFinished(const CaseDescription&) override {}
    void onShrinkTried(const CaseDescription&, bool) override {}
    void onTestFinished(const TestMetadata&, const TestResult&) override {}
  } silent;
  const TestResult result = checkProperty(property, TestMetadata{"p", "p"}, parameters, silent, {});
  REQUIRE(result.is<FailureResult>());
  std::ostringstream message;
  printResultMessage(result, message);
  CHECK_THAT(message.str(), ContainsSubstring("orientation, family grid\n{\"p0\":[2,0],\"p1\":[0,0],\"p\":[0,0]}\n") &&
                                ContainsSubstring("\necho '{\"p0\":[\"0x1p+1\",") &&
                                ContainsSubstring("| touchstone ask orientation -"));
}

TEST_CASE("rapidcheck: shapes, answers and enumerators print themselves") {
  CHECK(rc::toString(Segment2d{{0.1, 0}, {-2, 1e300}}) == "[[0.1,0],[-2,1e+300]]");
  CHECK(rc::toString(Location::boundary) == "boundary");
  CHECK(rc::toString(robust::segment_segment({{0, 0}, {2, 0}}, {{1, 0}, {3, 0}})) ==
        R"({"relation":"overlap","overlap":[[1,0],[2,0]]})");
}

}  // namespace touchstone::tests
