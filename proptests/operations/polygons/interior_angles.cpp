// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/interior_angles.h"

#include <cstdint>

#include "proptests/closed_rings.h"
#include "proptests/forward_error.h"
#include "proptests/rounded_answers.h"

namespace touchstone::proptests::interior_angles_tests {
namespace {

using Row = rows::interior_angles;

constexpr double pi = 0x1.921fb54442d18p+1;

/// Digits of pi: OEIS A000796.
const Rational& digits_of_pi() {
  static const Rational digits = Rational("314159265358979323846264338327950288419716939937510") /
                                 Rational("100000000000000000000000000000000000000000000000000");
  return digits;
}

Rational exactly(double x) { return exact(x); }
Rational exactly(const Rational& x) { return x; }

constexpr Gives<Row> gives;

/// Same numbers: for robust the same doubles, for the oracle rationals that round to them.
bool same(const std::vector<double>& a, const std::vector<double>& b) { return a == b; }
bool same(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Rational& x, const Rational& y) {
    return catalogue::nearest(x) == catalogue::nearest(y);
  });
}

}  // namespace

LAW("interior_angles: the list from another vertex on, and the other way round, has the same angles") {
  auto angles = ask(asked);
  Polygon2d ring = opened(std::get<0>(asked));
  std::rotate(ring.vertices.begin(), ring.vertices.begin() + 1, ring.vertices.end());
  std::rotate(angles.begin(), angles.begin() + 1, angles.end());
  if (!same(ask(Row::Question{ring}), angles)) return false;
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  std::reverse(angles.begin(), angles.end());
  return same(ask(Row::Question{ring}), angles);
}

TEST_CASE("interior_angles: similar polygons have the same angles") {
  const auto similar = [](const auto& ask, const auto& asked) {
    const auto angles = ask(asked);
    for (const Affine& map : axis_symmetries) {
      if (!same(ask(map(asked)), angles)) return false;
    }
    for (const int k : {1, 300, -300}) {
      auto larger = asked, back = asked;
      catalogue::for_each_number(larger, [&](double& number) { number = std::ldexp(number, k); });
      back = larger;
      catalogue::for_each_number(back, [&](double& number) { number = std::ldexp(number, -k); });
      if (numbers_of(back) == numbers_of(asked) && !same(ask(larger), angles)) return false;
    }
    // A turn and stretch: (x, y) -> (2x - y, x + 2y).
    static constexpr Affine turn{2, -1, 1, 2};
    return !on_lattice(asked) || same(ask(turn(asked)), angles);
  };
  law<Row>("the axes' symmetries, powers of two, a turn", similar);
}

LAW("interior_angles: the angles lie in (0, 2 pi) and add up to (n - 2) pi") {
  const auto angles = ask(asked);
  using Number = typename std::decay_t<decltype(angles)>::value_type;
  constexpr bool rounded = std::is_same_v<Number, double>;
  Rational sum(0);
  for (const Number& angle : angles) {
    if (rounded ? exactly(angle) < 0 || exactly(angle) > exact(2 * pi)
                : exactly(angle) <= 0 || exactly(angle) >= 2 * digits_of_pi())
      return false;
    sum += exactly(angle);
  }
  // A double below 8 is off by at most 2^-51, the oracle's rational by less than 2^-60 of twice that, and the digits
  // of pi by 10^-49.
  const auto n = static_cast<std::uint64_t>(angles.size());
  return abs(sum - (Rational(n) - 2) * digits_of_pi()) <=
         Rational(n) * (power_of_two(rounded ? -51 : -110) + power_of_two(-160));
}

TEST_CASE("interior_angles: p. 6's angles worked by hand") {
  gives({Polygon2d{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}}, {pi / 2, pi / 2, pi / 2, pi / 2});
  gives({Polygon2d{{{0, 0}, {0, 4}, {2, 4}, {4, 4}, {4, 0}}}}, {pi / 2, pi / 2, pi, pi / 2, pi / 2});
  gives({Polygon2d{{{0, 0}, {1, 0}, {0, 1}}}}, {pi / 2, pi / 4, pi / 4});
  // Tangents 1/2 and 2: OEIS A073000, A105199.
  gives({Polygon2d{{{0, 0}, {2, 0}, {2, 1}}}},
        {0.463647609000806116214256231461214402, pi / 2, 1.107148717794090503017065460178537040});
  // An L: 3 pi / 2 at (2, 2).
  gives({Polygon2d{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}}},
        {pi / 2, pi / 2, pi / 2, 4.71238898038468985769396507491925432629575, pi / 2, pi / 2});
  gives({Polygon2d{{{0, 4}, {2, 4}, {2, 2}, {4, 2}, {4, 0}, {0, 0}}}},
        {pi / 2, pi / 2, 4.71238898038468985769396507491925432629575, pi / 2, pi / 2, pi / 2});
}

TEST_CASE("interior_angles: a last position that repeats the first has no angle") {
  gives({Polygon2d{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}}}, {pi / 2, pi / 2, pi / 2, pi / 2});
  gives({Polygon2d{{{0, 0}, {1, 0}, {0, 1}, {-0.0, -0.0}}}}, {pi / 2, pi / 4, pi / 4});
}

TEST_CASE("interior_angles: what acos loses near 0 and pi") {
  // atan x = x - x^3 / 3 + ...: 2^-60, and pi / 2 less that. Its cosine rounds to 1.
  gives({Polygon2d{{{0, 0}, {1, 0}, {1, 0x1p-60}}}}, {0x1p-60, pi / 2, pi / 2}, "rounding");
  // The least angle that is no double: half of the least double and below rounds to 0, three quarters to the least
  // double.
  gives({Polygon2d{{{0, 0}, {0x1p900, 0}, {0x1p900, 0x1p-175}}}}, {0, pi / 2, pi / 2}, "invalid");
  gives({Polygon2d{{{0, 0}, {0x1p900, 0}, {0x1p900, 0x1.8p-175}}}}, {tiny, pi / 2, pi / 2}, "invalid");
  gives({Polygon2d{{{0, 0}, {0x1p1000, 0}, {0x1p1000, tiny}}}}, {0, pi / 2, pi / 2}, "invalid");
  // A notch of 2^-60 at its tip (0, 0): 2 pi less that is nearest to the double nearest to 2 pi.
  const std::vector<double> notched =
      robust::interior_angles({{{0, 0}, {1, 0}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}, {1, 0x1p-60}}});
  CHECK(notched[0] == 2 * pi);
}

TEST_CASE("interior_angles: polygons that are not simple are refused, naming the vertex and the edge") {
  refused<Row>({Polygon2d{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}}, "polygon[0]", "simple: its edge must not meet edge 2");
  refused<Row>({Polygon2d{{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}}, "polygon[1]",
               "different from vertex 2: drop one of the two");
  refused<Row>({Polygon2d{{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {0, 0}}}}, "polygon[3]",
               "different from vertex 0: drop one of the two");
  refused<Row>({Polygon2d{{{0, 0}, {1, 1}, {2, 2}}}}, "polygon[0]", "simple: its edge must not meet edge 2");
}

TEST_CASE("interior_angles: the formula in double stays within the bound of its contract") {
  std::uint64_t promised = 0;
  contract<Row>(
      "the forward error bound holds",
      [&](const auto& truth, const std::vector<double>& answer, const Polygon2d& given) {
        const Polygon2d ring = opened(given);
        std::vector<double> sines;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const auto corner = moderate_corner(ring, i);
          if (!corner) return true;
          const auto& [v, w] = *corner;
          const Rational turn = cross(v, w), squared(turn * turn / (dot(v, v) * dot(w, w)));
          if (squared <= power_of_two(-40)) return true;
          sines.push_back(std::sqrt(catalogue::nearest(squared)) * (1 - 0x1p-50));
        }
        ++promised;
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Rational bound = 11 * unit() / (exact(sines[i]) - power_of_two(-28)) + power_of_two(-48);
          if (!within(answer[i], truth.answer[i], bound)) return false;
        }
        return true;
      },
      96);
  CHECK(promised > 100);
}

}  // namespace touchstone::proptests::interior_angles_tests
