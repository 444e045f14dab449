// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"

// The filters of one polynomial on ALL inputs of windows of a toy format, in every environment: a certain answer is
// never wrong. And with a bound that is too small, or without its absolute term, wrong answers are found: the search
// has teeth.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int low = -14, high = 7;
using Five = Toy<5, low, high>;
using FiveFormat = ToyFormat<Five, 5, low, high>;
/// At 5 bits the circle's bound is as large as the polynomial itself: it hardly ever knows. At 6 it does.
using Six = Toy<6, low, high>;
using SixFormat = ToyFormat<Six, 6, low, high>;

/// Whatever cross_sign, and so orientation, can be asked where the coordinates of v and w are differences of numbers of
/// these windows.
Count crosses(const std::vector<double>& of_vx, const std::vector<double>& of_vy, const std::vector<double>& of_wx,
              const std::vector<double>& of_wy) {
  Count count;
  const auto all_vy = differences<Five>(of_vy), all_wx = differences<Five>(of_wx), all_wy = differences<Five>(of_wy);
  for (const auto& vx : differences<Five>(of_vx)) {
    for (const auto& vy : all_vy) {
      for (const auto& wx : all_wx) {
        for (const auto& wy : all_wy) {
          const auto said =
              filters::cross_sign<Five, FiveFormat>({vx.computed, vy.computed}, {wx.computed, wy.computed});
          count.add(said, sign_of(vx.exact * wy.exact - vy.exact * wx.exact));
        }
      }
    }
  }
  return count;
}
Count crosses(const std::vector<double>& of_v, const std::vector<double>& of_w) {
  return crosses(of_v, of_v, of_w, of_w);
}

template <class Float, class Format>
Count circles(const std::vector<double>& points, const std::vector<double>& radii) {
  Count count;
  const auto d = differences<Float>(points);
  for (const auto& x : d) {
    for (const auto& y : d) {
      for (const double radius : radii) {
        if (radius < 0) continue;
        const auto said = filters::circle<Float, Format>({x.computed, y.computed}, Float::of(radius));
        count.add(said, sign_of(radius * radius - x.exact * x.exact - y.exact * y.exact));
      }
    }
  }
  return count;
}

Count elevations(const std::vector<double>& slopes, const std::vector<double>& xs, const std::vector<double>& heights) {
  Count count;
  for (const double slope : slopes) {
    for (const double x : xs) {
      for (const double intercept : heights) {
        for (const double y : heights) {
          const auto said =
              filters::elevation<Five, FiveFormat>(Five::of(slope), Five::of(intercept), {Five::of(x), Five::of(y)});
          count.add(said, sign_of(y - (slope * x + intercept)));
        }
      }
    }
  }
  return count;
}

Count ordinary_crosses() { return crosses(half_binade<Five, FiveFormat>(-6), half_binade<Five, FiveFormat>(-6)); }
/// One vector around the least normal number, the other around 1; every y around the one, every x around the other;
/// both where products underflow; both at the guard and beyond.
Count extreme_crosses() {
  return crosses(window<Five>(8, low - 3), window<Five>(4, -2)) +
         crosses(window<Five>(4, -2), window<Five>(8, low - 3)) +
         crosses(window<Five>(4, -3), window<Five>(8, low - 3), window<Five>(4, -3), window<Five>(8, low - 3)) +
         crosses(window<Five>(6, low / 2 - 2), window<Five>(6, low / 2 - 2)) +
         crosses(window<Five>(6, -2), window<Five>(6, -2)) +
         crosses(window<Five>(5, high - 3), window<Five>(5, high - 3));
}
template <class Float, class Format>
Count ordinary_circles() {
  return circles<Float, Format>(half_binade<Float, Format>(-6), window<Float>(128, -6));
}
/// Where squares underflow, where lengths do, at the guard, at the end of the range.
template <class Float, class Format>
Count extreme_circles() {
  Count sum;
  for (const int exponent : {low / 2 - 4, low - 4, -3, high - 4})
    sum = sum + circles<Float, Format>(window<Float>(20, exponent), window<Float>(32, exponent));
  return sum;
}
Count ordinary_elevations() { return elevations(window<Five>(12, -3), window<Five>(12, -4), window<Five>(40, -5)); }
Count extreme_elevations() {
  return elevations(window<Five>(4, -1), window<Five>(12, low - 4), window<Five>(24, low - 4)) +
         elevations(window<Five>(12, low - 4), window<Five>(4, -1), window<Five>(12, low - 4)) +
         elevations(window<Five>(12, low / 2 - 2), window<Five>(12, low / 2 - 2), window<Five>(4, low - 4)) +
         elevations(window<Five>(8, high - 4), window<Five>(8, high - 4), window<Five>(8, high - 4));
}

template <class Float, class Ask>
std::uint64_t wrong(const Ask& ask) {
  return in_all_environments<Float>(ask).wrong;
}

}  // namespace

TEST_CASE("toy floats: no certain sign of a cross product is wrong") {
  for (int rounding = 0; rounding < 4; ++rounding) {
    Five::set({rounding, false, false});
    const Count count = ordinary_crosses();
    CHECK(count.wrong == 0);
    CHECK(count.certain > count.cases / 20);
  }
  CHECK(wrong<Five>(extreme_crosses) == 0);
}

TEST_CASE("toy floats: no certain side of a circle is wrong") {
  CHECK(wrong<Five>(ordinary_circles<Five, FiveFormat>) == 0);
  CHECK(wrong<Five>(extreme_circles<Five, FiveFormat>) == 0);
  const auto six = [] { return ordinary_circles<Six, SixFormat>() + extreme_circles<Six, SixFormat>(); };
  const Count count = in_all_environments<Six>(six);
  CHECK(count.wrong == 0);
  CHECK(count.certain > count.cases / 20);
}

TEST_CASE("toy floats: no certain height over a line is wrong") {
  const Count count = in_all_environments<Five>(ordinary_elevations);
  CHECK(count.wrong == 0);
  CHECK(count.certain > count.cases / 20);
  CHECK(wrong<Five>(extreme_elevations) == 0);
}

TEST_CASE("toy floats: bounds that are too small are found out") {
  {
    const Weakened<FiveFormat> weakened(1.0 / 16, 1);
    Five::set({2, false, false});
    CHECK(ordinary_crosses().wrong > 0);
    CHECK(wrong<Five>(ordinary_elevations) > 0);
  }
  {
    const Weakened<SixFormat> weakened(1.0 / 16, 1);
    Six::set({0, false, false});
    CHECK(ordinary_circles<Six, SixFormat>().wrong > 0);
  }
  {
    const Weakened<FiveFormat> weakened(1, 0);
    CHECK(wrong<Five>(extreme_crosses) > 0);
    CHECK(wrong<Five>(extreme_elevations) > 0);
  }
  {
    const Weakened<SixFormat> weakened(1, 0);
    CHECK(wrong<Six>(extreme_circles<Six, SixFormat>) > 0);
  }
}

}  // namespace touchstone::proptests
