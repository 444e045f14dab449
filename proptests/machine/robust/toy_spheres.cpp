// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"
#include "robust/kernel/sphere_filter.h"

// The filter of two balls on windows of a toy format, in every environment: a certain sign is never wrong, and bounds
// that are too small are found out.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int low = -14, high = 7;
using Five = Toy<5, low, high>;
using Format = ToyFormat<Five, 5, low, high>;

struct Windows {
  std::vector<double> x, y, radius;  ///< of one ball
};

/// All pairs of a ball of the one and a ball of the other; z does not differ.
Count balls(const Windows& first, const Windows& second) {
  Count count;
  for (const double ax : first.x)
    for (const double ay : first.y)
      for (const double ar : first.radius)
        for (const double bx : second.x)
          for (const double by : second.y)
            for (const double br : second.radius) {
              const Sphere3<Five> a{{Five::of(ax), Five::of(ay), Five::of(0)}, Five::of(ar)};
              const Sphere3<Five> b{{Five::of(bx), Five::of(by), Five::of(0)}, Five::of(br)};
              const double x = bx - ax, y = by - ay, reach = ar + br;
              count.add(filters::spheres<Five, Format>(a, b), sign_of(reach * reach - x * x - y * y));
            }
  return count;
}

/// Differences and sums that rounding moves as far as it can.
Count ordinary() {
  std::vector<double> large, fine;
  for (int k = 0; k <= 15; ++k) fine.push_back(std::ldexp(k, -8));
  for (int k = 16; k <= 26; ++k) large.push_back(std::ldexp(k, -4));
  return balls({window<Five>(15, -8), {0, 1.0 / 64}, fine}, {large, {0, 1}, large}) +
         balls({large, {0}, fine}, {window<Five>(15, -8), {0, 1.0 / 64}, large});
}

/// Where numbers are subnormal and others beside them are not; where squares underflow; at the guard and beyond it.
Count extreme() {
  const std::vector<double> least = window<Five>(6, low - 4), small = window<Five>(5, low / 2 - 3);
  const auto positive = [](std::vector<double> all) {
    std::erase_if(all, [](double x) { return x < 0; });
    return all;
  };
  return balls({least, {0, std::ldexp(1, low - 2)}, positive(least)},
               {{0.5, 1.75, 2, 3.75}, {0, 1}, {0.5, 1.75, 2, 3.75}}) +
         balls({least, {0}, positive(least)}, {small, {0}, positive(small)}) +
         balls({small, {0}, positive(small)}, {small, small, positive(small)}) +
         balls({window<Five>(4, high - 3), {0, 3}, {0, 1, 2, 8}}, {window<Five>(4, high - 3), {0, 4}, {0, 3, 4, 16}});
}

}  // namespace

TEST_CASE("toy floats: the sign for two balls is certain only where it is right") {
  CHECK(wrong_with<Five, Format>(1, 1, ordinary) == 0);
  CHECK(wrong_with<Five, Format>(1, 1, extreme) == 0);
}

TEST_CASE("toy floats: bounds for two balls that are too small are found out") {
  CHECK(wrong_with<Five, Format>(0.125, 0, ordinary) > 0);
  CHECK(wrong_with<Five, Format>(1, 0, extreme) > 0);
}

}  // namespace touchstone::proptests
