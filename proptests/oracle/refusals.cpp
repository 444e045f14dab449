// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "audit/catalogue/catalogue.h"
#include "audit/codec/walk.h"

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

/// A legal question: small numbers, all different.
template <class Row>
typename Row::Question legal() {
  typename Row::Question question{};
  double next = 1;
  audit::for_each_number(question, [&](double& number) { number = next, next += 1; });
  return question;
}

/// The field names in the order of the numbers, as they are written in JSON.
const std::map<std::string, std::vector<std::string>> fields{
    {"explicit_line", {"slope", "intercept", "point[0]", "point[1]"}},
    {"implicit_circle", {"circle.center[0]", "circle.center[1]", "circle.radius", "point[0]", "point[1]"}},
    {"parametric_circle", {"circle.center[0]", "circle.center[1]", "circle.radius", "u"}},
    {"line_point_at", {"line.origin[0]", "line.origin[1]", "line.direction[0]", "line.direction[1]", "t"}},
    {"point_on_segment", {"point[0]", "point[1]", "segment[0][0]", "segment[0][1]", "segment[1][0]", "segment[1][1]"}},
    {"line_line", {"a[0][0]", "a[0][1]", "a[1][0]", "a[1][1]", "b[0][0]", "b[0][1]", "b[1][0]", "b[1][1]"}},
    {"segment_segment", {"a[0][0]", "a[0][1]", "a[1][0]", "a[1][1]", "b[0][0]", "b[0][1]", "b[1][0]", "b[1][1]"}},
    {"ray_segment",
     {"ray.origin[0]", "ray.origin[1]", "ray.direction[0]", "ray.direction[1]", "segment[0][0]", "segment[0][1]",
      "segment[1][0]", "segment[1][1]"}},
    {"orientation", {"p0[0]", "p0[1]", "p1[0]", "p1[1]", "p[0]", "p[1]"}}};

}  // namespace

TEST_CASE("truth: a number that is not finite is refused by the name of its field, wherever it stands") {
  const double infinity = std::numeric_limits<double>::infinity();
  audit::for_each_row([&]<class Row>() {
    const auto& names = fields.at(Row::card().name);
    REQUIRE(refusal<Row>(legal<Row>()) == "answered");
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (const double wrong : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        auto question = legal<Row>();
        std::size_t at = 0;
        audit::for_each_number(question, [&](double& number) { number = at++ == i ? wrong : number; });
        CHECK(refusal<Row>(question) == names[i] + ": finite number");
      }
    }
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
