// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"

// How far the filters' bounds are from the least possible. Ten bits, because at five the terms of higher order are as
// large as the first, and all exponents that a filter may meet here, because underflow is not what is asked. Nothing is
// tabulated: there are too many numbers.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int bits = 10;
constexpr double ulp = 1.0 / (1 << (bits - 1));  // of 1

struct Short {
  inline static int mode = 0;  ///< as ToyMode::rounding
  static Short rounded(double exact) { return {Toy<bits, -200, 40>::rounded(exact, {mode, false, false})}; }
  double value = 0;
  friend Short operator+(Short a, Short b) { return rounded(a.value + b.value); }
  friend Short operator-(Short a, Short b) { return rounded(a.value - b.value); }
  friend Short operator*(Short a, Short b) { return rounded(a.value * b.value); }
  friend bool operator>(Short a, Short b) { return a.value > b.value; }
  friend bool operator<=(Short a, Short b) { return a.value <= b.value; }
};

struct ShortFormat {
  static constexpr int precision = bits, min_exponent = -200, max_exponent = 40;
  inline static double relative = 1;  ///< multiplies the bounds, not the guards
  static Short above(double c) { return {Toy<bits, -200, 40>::rounded(c < 1 ? c * relative : c, {2, false, false})}; }
  static Short magnitude(Short x) { return {std::fabs(x.value)}; }
};

/// Differences of two numbers just beside 1, 1 + ulp / 2 and 1 + ulp: rounding moves them as far as it can.
std::vector<double> much_rounded() {
  std::vector<double> differences;
  for (int halves = 0; halves <= 2; ++halves) {
    for (const double beside : {-ulp / 64, ulp / 64}) {
      const double difference = 1 + halves * ulp / 2 + beside;
      differences.push_back(difference), differences.push_back(-difference);
    }
  }
  return differences;
}

Count crosses() {
  Count count;
  const std::vector<double> all = much_rounded();
  const auto computed = [](double x, double y) { return Vector2<Short>{Short::rounded(x), Short::rounded(y)}; };
  for (const double vx : all) {
    for (const double vy : all) {
      for (const double wx : all) {
        for (const double wy : all) {
          count.add(filters::cross_sign<Short, ShortFormat>(computed(vx, vy), computed(wx, wy)),
                    sign_of(vx * wy - vy * wx));
        }
      }
    }
  }
  return count;
}

/// Every radius of a binade, points near its end on the right that rounding moves much, and a little up from there.
Count circles() {
  Count count;
  for (double radius = 1; radius < 2; radius += ulp) {
    for (int halves = -5; halves <= 5; ++halves) {
      for (const double beside : {-ulp / 64, ulp / 64}) {
        for (const double y : {0.0, ulp / 64, ulp, 1.0 / 64}) {
          const double x = radius + halves * ulp / 2 + beside;
          count.add(filters::circle<Short, ShortFormat>({Short::rounded(x), {y}}, {radius}),
                    sign_of(radius * radius - x * x - y * y));
        }
      }
    }
  }
  return count;
}

template <class Ask>
std::uint64_t wrong_with(double relative, const Ask& ask) {
  ShortFormat::relative = relative;
  std::uint64_t wrong = 0;
  for (Short::mode = 0; Short::mode < 4; ++Short::mode) wrong += ask().wrong;
  ShortFormat::relative = 1;
  return wrong;
}

}  // namespace

TEST_CASE("toy floats: half of the bound of a cross product, or of a circle, is too small") {
  CHECK(wrong_with(1, crosses) == 0);
  CHECK(wrong_with(0.5, crosses) > 0);
  CHECK(wrong_with(1, circles) == 0);
  CHECK(wrong_with(0.5, circles) > 0);
}

}  // namespace touchstone::proptests
