// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"
#include "robust/kernel/sphere_box_filter.h"

// The filter of a ball and a box on windows of a toy format, in every environment: a certain sign is never wrong, and
// bounds that are too small are found out.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int low = -14, high = 7;
using Five = Toy<5, low, high>;
using Format = ToyFormat<Five, 5, low, high>;

struct Windows {
  std::vector<double> x, y, radius;  ///< of the ball
};

/// All balls beside a box whose corner is (x, y) of another window and which is `width` wide, a third axis inside.
Count beside(const Windows& balls, const std::vector<double>& corner, double width) {
  Count count;
  const auto interval = [](double c, double min, double max) {
    return filters::beyond_interval(Five::of(c), Five::of(min), Five::of(max));
  };
  for (const double max : corner)
    for (const double x : balls.x)
      for (const double y : balls.y)
        for (const double radius : balls.radius) {
          const double min = max - width, dx = std::max(x - max, min - x), dy = std::max(y - max, min - y);
          if (Five::rounded(min, {}) != min) continue;
          const double sx = std::max(dx, 0.0), sy = std::max(dy, 0.0);
          count.add(filters::ball_and_box<Five, Format>(Five::of(radius), interval(x, min, max), interval(y, min, max),
                                                        interval(0, -width, width)),
                    sign_of(radius * radius - sx * sx - sy * sy));
        }
  return count;
}

std::vector<double> positive(std::vector<double> all) {
  std::erase_if(all, [](double x) { return x < 0; });
  return all;
}

/// Differences that rounding moves as far as it can.
Count ordinary() {
  std::vector<double> large, fine;
  for (int k = 0; k <= 15; ++k) fine.push_back(std::ldexp(k, -8));
  for (int k = 16; k <= 26; ++k) large.push_back(std::ldexp(k, -4));
  return beside({large, large, large}, fine, 1.0 / 64) +
         beside({large, {0, 1.0 / 64}, large}, window<Five>(15, -8), 0.5);
}

/// Where numbers are subnormal and others beside them are not; where squares underflow; at the guard and beyond it.
Count extreme() {
  const std::vector<double> least = window<Five>(6, low - 4), small = window<Five>(8, low / 2 - 3);
  return beside({least, least, positive(least)}, {0, std::ldexp(1, low - 4)}, std::ldexp(1, low - 1)) +
         beside({small, small, positive(small)}, small, 0.5) +
         beside({window<Five>(4, high - 3), {0, 3}, {0, 1, 2, 8}}, window<Five>(4, high - 3), 4);
}

}  // namespace

TEST_CASE("toy floats: the sign for a ball and a box is certain only where it is right") {
  CHECK(wrong_with<Five, Format>(1, 1, ordinary) == 0);
  CHECK(wrong_with<Five, Format>(1, 1, extreme) == 0);
}

TEST_CASE("toy floats: bounds for a ball and a box that are too small are found out") {
  CHECK(wrong_with<Five, Format>(0.125, 0, ordinary) > 0);
  CHECK(wrong_with<Five, Format>(1, 0, extreme) > 0);
}

}  // namespace touchstone::proptests
