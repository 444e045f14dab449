// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"
#include "robust/kernel/face_filter.h"

// The filter of a face's plane on windows of a toy format, in every environment: a certain side is never wrong, and
// bounds that are too small are found out.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int low = -30, high = 7;
using Six = Toy<6, low, high>;
using Format = ToyFormat<Six, 6, low, high>;

struct Axes {
  std::vector<double> x, y, z;
};

/// All b, c and p with coordinates in these windows, as seen from a.
Count faces(const Point3<double>& a, const Axes& b, const Axes& c, const Axes& p) {
  Count count;
  const auto toy = [](double x, double y, double z) { return Point3<Six>{Six::of(x), Six::of(y), Six::of(z)}; };
  for (const double bx : b.x)
    for (const double by : b.y)
      for (const double bz : b.z)
        for (const double cx : c.x)
          for (const double cy : c.y)
            for (const double cz : c.z) {
              const filters::FacePlane<Six, Format> plane(toy(a.x, a.y, a.z), toy(bx, by, bz), toy(cx, cy, cz));
              const Vector3<double> normal =
                  cross(Point3<double>{bx, by, bz} - a, Point3<double>{cx, cy, cz} - a);  // exact, as the next
              for (const double px : p.x)
                for (const double py : p.y)
                  for (const double pz : p.z)
                    count.add(plane.side(toy(px, py, pz)), sign_of(dot(normal, Point3<double>{px, py, pz} - a)));
            }
  return count;
}

/// Differences that are rounded, relatively most of all, and terms that nearly cancel. They add up to less than the
/// guard.
Count ordinary() {
  const auto scaled = [](std::vector<double> numbers) {
    for (double& number : numbers) number = std::ldexp(number, -9);
    return numbers;
  };
  const std::vector<double> few = scaled({33, 43, 49}), some = scaled({-35, 33, 39, 51}), two = scaled({37, 47}),
                            dense = scaled({33, 35, 37, 39, 41, 43, 47, 51, 55, 59, 63}), zero{0}, one = scaled({61});
  const Point3<double> a{-33 * 0x1p-9, -35 * 0x1p-9, -37 * 0x1p-9}, below{-33 * 0x1p-9, -37 * 0x1p-9, 0};
  return faces(a, {some, few, two}, {few, some, few}, {two, few, some}) +
         faces(below, {dense, dense, zero}, {dense, dense, zero}, {two, few, one});
}

/// Where all that lies along one axis is subnormal or just above it, beside others at the guard or beyond it; where
/// products underflow.
Count extreme() {
  const std::vector<double> least = window<Six>(3, low - 1), less{0x1p-13, -0x1.8p-12}, small{-0x1p-7, 0x1.8p-8},
                            large{0.125, -0.25}, larger{-1.75, 0.875};
  return faces({0, 0, 0}, {least, large, large}, {least, large, large}, {least, large, large}) +
         faces({0, 0, 0}, {large, larger, least}, {large, large, least}, {larger, large, least}) +
         faces({0, 0, 0}, {small, less, small}, {less, small, small}, {small, small, less}) +
         faces({0, 0, 0}, {larger, small, larger}, {larger, larger, small}, {{64, 128}, larger, {-128, 1}});
}

}  // namespace

TEST_CASE("toy floats: no certain side of a face is wrong") {
  for (int rounding = 0; rounding < 4; ++rounding) {
    Six::set({rounding, false, false});
    CHECK(ordinary().wrong == 0);
  }
  CHECK(in_all_environments<Six>(extreme).wrong == 0);
}

TEST_CASE("toy floats: a bound of a face that is too small is found out") {
  {
    const Weakened<Format> weakened(1.0 / 32, 1);
    std::uint64_t wrong = 0;
    for (int rounding = 0; rounding < 4; ++rounding) {
      Six::set({rounding, false, false});
      wrong += ordinary().wrong;
    }
    CHECK(wrong > 0);
  }
  const Weakened<Format> weakened(1, 0);
  CHECK(in_all_environments<Six>(extreme).wrong > 0);
}

}  // namespace touchstone::proptests
