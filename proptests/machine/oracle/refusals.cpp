// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "catalogue/catalogue.h"
#include "catalogue/codec/walk.h"

namespace touchstone::proptests {
namespace {

template <class Row, class Question>
std::string refusal(const Question& question) {
  try {
    audit::ask_oracle<Row>(question);
    return "answered";
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

}  // namespace

TEST_CASE("truth: a number that is not finite is refused, wherever it stands, each by a name of its own") {
  const double infinity = std::numeric_limits<double>::infinity();
  audit::for_each_row([&]<class Row>() {
    audit::Choices simplest = audit::Choices::replayed({});
    const auto valid = Row::hard_cases()[0].draw(simplest);
    REQUIRE(refusal<Row>(valid) == "answered");
    std::set<std::string> named;
    std::size_t numbers = 0;
    audit::for_each_number(valid, [&](const double&) { ++numbers; });
    for (std::size_t i = 0; i < numbers; ++i) {
      for (const double wrong : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        auto question = valid;
        std::size_t at = 0;
        audit::for_each_number(question, [&](double& number) { number = at++ == i ? wrong : number; });
        const std::string said = refusal<Row>(question), rule = ": finite number";
        CHECK(said.size() > rule.size());
        CHECK(said.substr(said.size() - rule.size()) == rule);
        named.insert(said);
      }
    }
    CHECK(named.size() == numbers);
  });
}

TEST_CASE("truth: shapes without a meaning are refused by field and rule") {
  const Point2d p{0.5, -2};
  const Segment2d s{p, {1, 1}};
  const auto refused = []<class Row>(const Row&, const typename Row::Question& question) {
    return refusal<Row>(question);
  };
  using namespace audit::rows;
  CHECK(refused(line_line{}, {{p, p}, {p, p}}) == "a: two distinct points");
  CHECK(refused(line_line{}, {{p, {0, 0}}, {{0.0, 1}, {-0.0, 1}}}) == "b: two distinct points");
  CHECK(refused(ray_segment{}, {{p, {0.0, -0.0}}, s}) == "ray.direction: nonzero direction");
  CHECK(refused(line_point_at{}, {{p, {-0.0, 0.0}}, 1}) == "line.direction: nonzero direction");
  CHECK(refused(implicit_circle{}, {{p, -5e-324}, p}) == "circle.radius: radius >= 0");
  CHECK(refused(parametric_circle{}, {{p, -1}, 1}) == "circle.radius: radius >= 0");
  CHECK(refused(implicit_circle{}, {{p, -0.0}, p}) == "answered");
}

}  // namespace touchstone::proptests
