// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdint>

#include "catalogue/operation/operation.h"
#include "catalogue/rows/lines/implicit_circle.h"
#include "catalogue/rows/lines/line_line.h"
#include "catalogue/rows/lines/line_point_at.h"
#include "catalogue/rows/lines/orientation.h"
#include "catalogue/rows/lines/parametric_circle.h"
#include "catalogue/rows/lines/point_on_segment.h"
#include "catalogue/rows/lines/ray_segment.h"
#include "catalogue/rows/lines/segment_segment.h"
#include "oracle/exact/numbers/decode.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/lines/explicit_line.h"
#include "proptests/catch.h"
#include "proptests/property.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::rationals_tests {
namespace {

using catalogue::DrawStream;
using oracle::Rational;
using Segment = Segment2<Rational>;
using Line = Line2<Rational>;
using Ray = Ray2<Rational>;
using Circle = Circle2<Rational>;

template <class Row>
using Rationals = catalogue::rebound_t<typename Row::Question, Rational>;

template <class Row>
Rationals<Row> exactly(const typename Row::Question& question) {
  return catalogue::converted<Rational>(question, [](double number) { return oracle::exact(number); });
}

/// The truth, its margin, or the refusal, in words.
template <class Row, class Question>
std::string said(const Question& question) {
  try {
    const auto truth = catalogue::ask_oracle<Row>(question);
    return catalogue::to_json(truth.answer).dump() + ", margin " + truth.margin->get_str();
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
}

Rational half_to_the(int power) { return Rational(1, mpz_class(1) << power); }

/// Irrational coordinates: each overload gives some rational closer than 2^-60 units in the last place.
bool as_close_as_promised(const Rational& one, const Rational& other) {
  Rational ulp = half_to_the(1074);
  mpq_mul_2exp(ulp.get_mpq_t(), ulp.get_mpq_t(), static_cast<mp_bitcnt_t>(oracle::ulp_exponent(one) + 1074));
  return abs(Rational(one - other)) < Rational(2 * ulp * half_to_the(60)) &&
         oracle::nearest_double(one) == oracle::nearest_double(other);
}

bool same_circle_point(const Circle2d& circle, double u) {
  const auto exact_circle = catalogue::converted<Rational>(circle, [](double number) { return oracle::exact(number); });
  const auto doubles = oracle::parametric_circle(circle, u);
  const auto rationals = oracle::parametric_circle(exact_circle, oracle::exact(u));
  return as_close_as_promised(doubles.answer.x, rationals.answer.x) &&
         as_close_as_promised(doubles.answer.y, rationals.answer.y) &&
         abs(Rational(*doubles.margin - *rationals.margin)) < half_to_the(58);
}

/// The points of an answer, times a factor.
template <class Answer>
Answer enlarged(Answer answer, const Rational& factor) {
  const auto enlarge = [&](Point2<Rational>& p) { p.x *= factor, p.y *= factor; };
  if constexpr (requires { answer.point; }) {
    if (answer.point) enlarge(*answer.point);
  }
  if constexpr (requires { answer.overlap; }) {
    if (answer.overlap) enlarge(answer.overlap->a), enlarge(answer.overlap->b);
  }
  return answer;
}

/// Decimals, so that nothing is rounded on the way.
Rational typed(const std::string& digits) {
  const auto dot = digits.find('.');
  if (dot == std::string::npos) return Rational(digits, 10);
  std::string whole = digits;
  whole.erase(dot, 1);
  Rational result(whole + "/1" + std::string(digits.size() - dot - 1, '0'), 10);
  result.canonicalize();
  return result;
}
Point2<Rational> at(const std::string& x, const std::string& y) { return {typed(x), typed(y)}; }
Vector2<Rational> by(const std::string& x, const std::string& y) { return {typed(x), typed(y)}; }

}  // namespace

TEST_CASE("rationals: the truth for doubles and for the rationals that they are is one truth") {
  for (const catalogue::Operation* operation : catalogue::all_operations()) {
    const catalogue::RowFunctions& row = operation->row();
    if (row.solve_as_typed == nullptr) continue;
    const auto said = [&](const auto& solve) -> std::string {
      try {
        const catalogue::Solution solution = solve();
        return catalogue::one_line(operation->answer_json(solution.answer)) + ", margin " +
               (solution.margin ? solution.margin->get_str() : "none");
      } catch (const InvalidInput& refused) {
        return refused.what();
      }
    };
    int different = 0;
    for (std::size_t family = 0; family < operation->families().size(); ++family) {
      for (int i = 0; i < scaled(40); ++i) {
        DrawStream draws = DrawStream::seeded(catalogue::seed_of(i, "rationals", family));
        const catalogue::Question question = operation->draw(draws, family);
        const auto exactly =
            catalogue::encoded_with<Rational>(question, [](double number) { return oracle::exact(number); });
        const std::string by_doubles = said([&] { return row.solve(question); }),
                          by_rationals = said([&] { return row.solve_as_typed(exactly); });
        if (by_doubles == by_rationals) continue;
        if (operation->name() == std::string("parametric_circle")) {
          using Asked = catalogue::rows::parametric_circle::Question;
          if (std::apply(same_circle_point, catalogue::unpacked<Asked>(question))) continue;
        }
        ++different;
        CAPTURE(operation->name(), operation->families()[family], i, by_doubles, by_rationals);
        CHECK(different == 0);
      }
    }
  }
}

TEMPLATE_TEST_CASE("rationals: a third of every length is a third of every point and a ninth of the margin", "",
                   catalogue::rows::implicit_circle, catalogue::rows::point_on_segment, catalogue::rows::line_line,
                   catalogue::rows::segment_segment, catalogue::rows::ray_segment, catalogue::rows::orientation) {
  const Rational third(1, 3);
  const catalogue::Operation& operation = catalogue::operation_of_row<TestType>();
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    for (int i = 0; i < scaled(20); ++i) {
      DrawStream draws = DrawStream::seeded(catalogue::seed_of(i, "thirds", family));
      const auto question =
          exactly<TestType>(catalogue::unpacked<typename TestType::Question>(operation.draw(draws, family)));
      const auto smaller =
          catalogue::converted<Rational>(question, [&](const Rational& n) { return Rational(n * third); });
      try {
        auto truth = catalogue::ask_oracle<TestType>(question);
        truth.answer = enlarged(truth.answer, third), *truth.margin /= 9;
        CHECK(said<TestType>(smaller) ==
              catalogue::to_json(truth.answer).dump() + ", margin " + truth.margin->get_str());
      } catch (const InvalidInput& refused) {
        CHECK(said<TestType>(smaller) == refused.what());
      }
    }
  }
}

TEMPLATE_TEST_CASE(
    "rationals: where whole numbers stop to fit machine words, a large factor changes nothing but the size", "",
    catalogue::rows::implicit_circle, catalogue::rows::point_on_segment, catalogue::rows::line_line,
    catalogue::rows::segment_segment, catalogue::rows::ray_segment, catalogue::rows::orientation) {
  const Rational factor((mpz_class(1) << 89) - 1);  // a prime: there is no common factor to take out again
  const typename TestType::Question shape{};
  int different = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(i, "words", 0));
    // Few values, so that points coincide and lie on one line; near the most that so many bits hold, or anywhere
    // within.
    const std::uint64_t bits = 58 + draws.below(8);
    std::array<mpz_class, 4> values;
    for (mpz_class& value : values) {
      value = (mpz_class(1) << bits) - 1;
      value -= draws.below(3) != 0 ? mpz_class(draws.below(4)) : mpz_class(draws.any_bits() >> 2) % value;
    }
    const auto question = catalogue::converted<Rational>(shape, [&](double) {
      const mpz_class& value = values[draws.below(4)];
      return Rational(draws.below(2) == 0 ? value : mpz_class(-value));
    });
    const auto larger =
        catalogue::converted<Rational>(question, [&](const Rational& n) { return Rational(n * factor); });
    try {
      auto truth = catalogue::ask_oracle<TestType>(question);
      truth.answer = enlarged(truth.answer, factor), *truth.margin *= factor * factor;
      different +=
          said<TestType>(larger) != catalogue::to_json(truth.answer).dump() + ", margin " + truth.margin->get_str();
    } catch (const InvalidInput& refused) {
      different += said<TestType>(larger) != refused.what();
    }
  }
  CHECK(different == 0);
}

TEST_CASE("rationals: typed decimals mean what they say, where the doubles next to them do not") {
  CHECK(oracle::explicit_line(typed("0.1"), typed("0.2"), at("3", "0.5")).answer == Height::on);
  CHECK(oracle::explicit_line(0.1, 0.2, {3, 0.5}).answer != Height::on);

  CHECK(oracle::implicit_circle(Circle{at("0", "0"), typed("0.5")}, at("0.3", "0.4")).answer == Location::boundary);
  CHECK(oracle::implicit_circle({{0, 0}, 0.5}, {0.3, 0.4}).answer != Location::boundary);

  CHECK(oracle::orientation(at("0.1", "0.1"), at("0.2", "0.3"), at("0.3", "0.5")).answer == Side::on);
  CHECK(oracle::orientation({0.1, 0.1}, {0.2, 0.3}, {0.3, 0.5}).answer != Side::on);

  const auto on = oracle::point_on_segment(at("0.3", "0.1"), Segment{at("0", "0"), at("0.9", "0.3")});
  CHECK((on.answer.relation == Incidence::on && on.answer.t == Rational(1, 3) && on.margin == 0));
  CHECK(oracle::point_on_segment({0.3, 0.1}, {{0, 0}, {0.9, 0.3}}).answer.relation == Incidence::off);

  const auto crossing = oracle::line_line(Line{at("0", "0"), at("0.1", "0.3")}, Line{at("0.3", "0"), at("0.2", "0.3")});
  CHECK((crossing.answer.ta == Rational(3, 2) && crossing.answer.tb == Rational(3, 2)));
  CHECK((crossing.answer.point == at("0.15", "0.45") && crossing.margin == typed("0.06")));
  const auto parallel = oracle::line_line(Line{at("0", "0"), at("0.1", "0.3")}, Line{at("1", "0"), at("1.1", "0.3")});
  CHECK(parallel.answer.relation == LineRelation::parallel);
  CHECK(oracle::line_line({{0, 0}, {0.1, 0.3}}, {{1, 0}, {1.1, 0.3}}).answer.relation == LineRelation::crossing);

  const auto touch =
      oracle::segment_segment(Segment{at("0", "0"), at("0.9", "0.3")}, Segment{at("0.3", "0.1"), at("1", "9")});
  CHECK(
      (touch.answer.ta == Rational(1, 3) && touch.answer.tb == Rational(0) && touch.answer.point == at("0.3", "0.1")));
  CHECK(oracle::segment_segment({{0, 0}, {0.9, 0.3}}, {{0.3, 0.1}, {1, 9}}).answer.relation ==
        SegmentRelation::disjoint);

  const auto overlap =
      oracle::ray_segment(Ray{at("0.1", "0.7"), by("0.1", "0.2")}, Segment{at("0.4", "1.3"), at("0.3", "1.1")});
  CHECK((overlap.answer.relation == RayRelation::overlap && overlap.answer.t == Rational(2)));
  CHECK((overlap.answer.overlap->a == at("0.3", "1.1") && overlap.answer.overlap->b == at("0.4", "1.3")));

  CHECK(oracle::line_point_at(ParametricLine2<Rational>{at("0.1", "0.2"), by("0.1", "0.1")}, Rational(3)).answer ==
        at("0.4", "0.5"));
  CHECK(oracle::parametric_circle(Circle{at("0.2", "0.3"), typed("0.1")}, Rational(0)).answer == at("0.3", "0.3"));
  CHECK(oracle::parametric_circle(Circle{at("0.2", "0.3"), Rational(0)}, typed("0.7")).answer == at("0.2", "0.3"));
}

TEST_CASE("rationals: refused with the field and the rule that doubles are refused with") {
  const auto p = at("0.1", "0.2");
  const auto zero = by("0", "0");
  const Segment s{p, p};
  CHECK(refusal_of([&] { oracle::line_line(Line{p, p}, Line{p, p}); }) == "a: two distinct points");
  CHECK(refusal_of([&] { oracle::line_line(Line{p, at("0", "0")}, Line{p, p}); }) == "b: two distinct points");
  CHECK(refusal_of([&] { oracle::ray_segment(Ray{p, zero}, s); }) == "ray.direction: nonzero direction");
  CHECK(refusal_of([&] {
          oracle::line_point_at(ParametricLine2<Rational>{p, zero}, Rational(1));
        }) == "line.direction: nonzero direction");
  CHECK(refusal_of([&] { oracle::implicit_circle(Circle{p, typed("-0.1")}, p); }) == "circle.radius: radius >= 0");
  CHECK(refusal_of([&] {
          oracle::parametric_circle(Circle{p, typed("-0.1")}, Rational(1));
        }) == "circle.radius: radius >= 0");
}

}  // namespace touchstone::proptests::rationals_tests
