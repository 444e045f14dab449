// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/line_point_at.h"

#include <algorithm>

#include "proptests/forward_error.h"

namespace touchstone::proptests::line_point_at_tests {
namespace {

using Row = rows::line_point_at;

Rational product(double a, double b) { return Rational(catalogue::exact_value(a) * catalogue::exact_value(b)); }

}  // namespace

LAW("line_point_at: the opposite direction at -t gives the same point, t = 0 the origin", line, t) {
  const Vector2d opposite{-line.direction.x, -line.direction.y};
  const auto start = ask(Row::Question{line, 0.0});
  return equal(ask(asked), ask(Row::Question{{line.origin, opposite}, -t})) && start.x == line.origin.x &&
         start.y == line.origin.y;
}

LAW("line_point_at: a power of two may go from t to the direction", line, t) {
  for (const int k : {1, -30, 500}) {
    const Vector2d longer{std::ldexp(line.direction.x, k), std::ldexp(line.direction.y, k)};
    const double less = std::ldexp(t, -k);
    const bool exact = std::ldexp(longer.x, -k) == line.direction.x && std::ldexp(longer.y, -k) == line.direction.y &&
                       std::ldexp(less, k) == t;
    if (exact && !equal(ask(asked), ask(Row::Question{{line.origin, longer}, less}))) return false;
  }
  return true;
}

ROBUST_LAW("line_point_at: IEEE 754's own sum and product are its special cases", line, t) {
  const Vector2d& v = line.direction;
  return equal(ask(Row::Question{line, 1.0}), Point2d{line.origin.x + v.x, line.origin.y + v.y}) &&
         equal(ask(Row::Question{{{0, 0}, v}, t}), Point2d{t * v.x, t * v.y});
}

TEST_CASE("line_point_at: p. 9's P0 + t V worked by hand") {
  example<Row>({{{1, 2}, {3, 4}}, 2}, {7, 10});
  example<Row>({{{1, 2}, {3, 4}}, -0.5}, {Rational(-1, 2), 0});
  example<Row>({{{1, 2}, {0, 4}}, 0.25}, {1, 3});
  example<Row>({{{0, 0}, {0.1, 10}}, 3}, {product(0.1, 3), 30});  // 3 * 0.1 is no double
}

TEST_CASE("line_point_at: two roundings are not one") {
  // (1 + 2^-27)^2 = 1 + 2^-26 + 2^-54, whose last term the product loses before the rest cancels.
  example<Row>({{{-(1 + 0x1p-26), 0}, {1 + 0x1p-27, 1}}, 1 + 0x1p-27},
               {catalogue::exact_value(0x1p-54), catalogue::exact_value(1 + 0x1p-27)}, "rounding");
}

TEST_CASE("line_point_at: huge, subnormal, beyond the range, negative zero") {
  const Rational h = catalogue::exact_value(huge), least = catalogue::exact_value(tiny);
  example<Row>({{{-huge, 0}, {huge, 1}}, 2}, {h, 2}, "invalid");    // 2 huge overflows, 2 huge - huge need not
  example<Row>({{{huge, 0}, {huge, 1}}, 1}, {Rational(2 * h), 1});  // the nearest double is infinity
  example<Row>({{{0, 0}, {tiny, tiny}}, 0.5},
               {Rational(least / 2), Rational(least / 2)});  // a tie: to 0, which is even
  example<Row>({{{0, 0}, {tiny, -tiny}}, 0.75}, {Rational(least * 3 / 4), Rational(-least * 3 / 4)});
  example<Row>({{{5, -0.0}, {1, 1}}, -0.0}, {5, 0});
  CHECK(std::signbit(robust::line_point_at({{0, 0}, {-tiny, 1}}, 0.5).x));  // not 0, so it keeps its sign
  CHECK_FALSE(std::signbit(robust::line_point_at({{-0.0, -0.0}, {1, 1}}, -0.0).x));
}

TEST_CASE("line_point_at: families draw products that overflow in sums that do not") {
  const Operation& operation = *catalogue::find_operation("line_point_at");
  for (const std::string name : {"overflowing", "at_end_of_range"}) {
    const auto& families = operation.families();
    const auto family = static_cast<std::size_t>(std::find(families.begin(), families.end(), name) - families.begin());
    int drawn = 0, overflowing = 0, last = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      DrawStream draws = DrawStream::seeded(i);
      const Question question = operation.draw(draws, family);
      const double dx = question.numbers[2], t = question.numbers[4];
      const Rational sum = catalogue::exact_value(question.numbers[0]) + product(dx, t);
      ++drawn;
      const bool within = abs(sum) < power_of_two(1024);
      overflowing += std::isinf(dx * t) && within;
      last += std::isinf(dx * t) && within && abs(sum) > power_of_two(1024) - power_of_two(974);
    }
    INFO(name);
    CHECK(overflowing > drawn / 2);  // the rest was scaled by a power of two
    if (name == "at_end_of_range") CHECK(last > drawn / 2);
  }
}

CONTRACT("line_point_at: the formula in double stays within the bound of its contract", line, t) {
  const auto kept = [&](double origin, double direction, double computed, const Rational& exactly) {
    const double product = t * direction;
    if (!finite(product, computed)) return true;
    return within(computed, exactly, unit() * size(product) + power_of_two(-1075) + unit() * size(origin + product));
  };
  return kept(line.origin.x, line.direction.x, answer.x, truth.answer.x) &&
         kept(line.origin.y, line.direction.y, answer.y, truth.answer.y);
}

TEST_CASE("line_point_at: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::line_point_at_tests
