// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/lines/parametric_circle.h"

#include "proptests/forward_error.h"
#include "proptests/rounded_answers.h"

namespace touchstone::proptests::parametric_circle_tests {

using Row = rows::parametric_circle;

constexpr double pi = 0x1.921fb54442d18p+1;  // the nearest double, 1.2246467991473532e-16 short of it

constexpr Gives<Row> gives;

TEST_CASE("parametric_circle: -u is the reflection in the axis through the centre") {
  robust_law<Row>(
      "cosine is even, sine is odd",
      [](const auto& ask, const auto& asked) {
        const auto& [circle, u] = asked;
        const Point2d here = ask(asked),
                      there = ask(Row::Question{{{circle.center.x, -circle.center.y}, circle.radius}, -u});
        return here.x == there.x && here.y == -there.y;
      },
      4);
}

TEST_CASE("parametric_circle: powers of two scale the point") {
  robust_law<Row>("scales by powers of two", scales<Row>, 4);
}

TEST_CASE("parametric_circle: u = 0 is the IEEE sum of centre and radius, radius 0 the centre") {
  robust_law<Row>(
      "simple cases",
      [](const auto& ask, const auto& asked) {
        const auto& [circle, u] = asked;
        return equal(ask(Row::Question{circle, 0.0}), Point2d{circle.center.x + circle.radius, circle.center.y}) &&
               equal(ask(Row::Question{{circle.center, 0.0}, u}), circle.center);
      },
      4);
}

TEST_CASE("parametric_circle: the squares of cosine and sine add up to 1 as nearly as their rounding allows") {
  robust_law<Row>(
      "unit circle",
      [](const auto& ask, const auto& asked) {
        const Point2d p = ask(Row::Question{{{0, 0}, 1}, std::get<1>(asked)});
        // Each coordinate c of at most 1 is off by e <= 2^-54, its square by 2 |c| e + e^2.
        const Rational e = catalogue::exact_value(0x1p-54), x = catalogue::exact_value(p.x),
                       y = catalogue::exact_value(p.y);
        return abs(x * x + y * y - 1) <= 2 * e * (abs(x) + abs(y)) + 4 * e * e;
      },
      4);
}

TEST_CASE("parametric_circle: p. 8's (r cos u, r sin u) worked by hand") {
  gives({{{1, 2}, 3}, 0}, {4, 2});
  gives({{{1, 2}, 0}, 12345}, {1, 2});
  // Digits of cos 1 and sin 1: OEIS A049470, A049469.
  gives({{{0, 0}, 1}, 1}, {0.54030230586813971740093660744297660373, 0.84147098480789650665250232163029899962});
  gives({{{0, 0}, 0x1p10}, -1},
        {0x1p10 * 0.54030230586813971740093660744297660373, -0x1p10 * 0.84147098480789650665250232163029899962});
  // sin(pi - d) = d and cos(pi - d) = -1 + d^2 / 2 up to terms far below an ulp; the same at half of each.
  gives({{{0, 0}, 1}, pi}, {-1, 1.2246467991473531772260659e-16});
  gives({{{0, 0}, 1}, pi / 2}, {6.1232339957367658861303299e-17, 1});
  // u - u^3 / 6: at 2^-30 the cube is far below half an ulp of u; 1 - u^2 / 2 = 1 - 2^-61 rounds to 1.
  gives({{{0, 0}, 1}, 0x1p-30}, {1, 0x1p-30});
}

TEST_CASE("parametric_circle: what cancels is computed anew, not from a rounded cosine") {
  // -1 + cos(2^-30) = -2^-61 + 2^-120 / 24 - ...; the formula rounds the cosine to 1.
  gives({{{-1, 0}, 1}, 0x1p-30}, {-0x1p-61, 0x1p-30}, "rounding");
}

TEST_CASE("parametric_circle: huge and subnormal angles and radii, negative zero") {
  gives({{{0, 0}, 1}, tiny}, {1, tiny});
  gives({{{0, 0}, tiny}, 1}, {tiny, tiny});  // 0.54 and 0.84 of the least double round to it
  gives({{{0, 0}, tiny}, 1.5}, {0, tiny});   // cos 1.5 = 0.07
  gives({{{0, 0}, 1}, -0.0}, {1, 0});
  gives({{{huge, 0}, huge}, 0}, {infinity, 0});
  gives({{{-huge, 0}, huge}, 0}, {0, 0});
  // 10^22 is a double; its sine is a well-known trap (K. C. Ng, "Good to the last bit").
  gives({{{0, 0}, 1}, 1e22}, {0.52321478539513894549759447338470949214, -0.85220084976718880177270589375302936826});
}

CONTRACT("parametric_circle: the formula in double stays within the bound of its contract", circle, u) {
  const Rational w = unit();
  const auto kept = [&](double center, double turn, double computed, const Rational& exactly) {
    const double product = circle.radius * turn;
    if (!finite(product, computed)) return true;
    // The oracle's rational is within 2^-60 units in the last place of the irrational truth.
    const Rational slack = abs(exactly) * power_of_two(-112) + power_of_two(-1134);
    const Rational bound =
        (3 + 2 * w) * w * size(product) + w * size(center + product) + (exact(circle.radius) + 1) * power_of_two(-1074);
    return within(computed, exactly, bound + slack);
  };
  return kept(circle.center.x, std::cos(u), answer.x, truth.answer.x) &&
         kept(circle.center.y, std::sin(u), answer.y, truth.answer.y);
}

}  // namespace touchstone::proptests::parametric_circle_tests
