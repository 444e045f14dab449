// SPDX-License-Identifier: Apache-2.0
#include "proptests/machine/robust/toy_windows.h"
#include "robust/kernel/plane_filter.h"

// The filter of a plane on windows of a toy format, in every environment: a certain side is never wrong, and bounds
// that are too small are found out.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;

constexpr int low = -14, high = 7;
using Five = Toy<5, low, high>;
using Format = ToyFormat<Five, 5, low, high>;

struct Windows {
  std::vector<double> x, y, z;  ///< of a coordinate of the normal and of the point alike
  std::vector<double> offsets;
};

/// All planes and points with coordinates in these windows.
Count planes(const Windows& normal, const Windows& point) {
  Count count;
  for (const double nx : normal.x)
    for (const double ny : normal.y)
      for (const double nz : normal.z)
        for (const double d : normal.offsets)
          for (const double px : point.x)
            for (const double py : point.y)
              for (const double pz : point.z) {
                const Plane<Five> plane{{Five::of(nx), Five::of(ny), Five::of(nz)}, Five::of(d)};
                const Point3<Five> p{Five::of(px), Five::of(py), Five::of(pz)};
                count.add(filters::plane<Five, Format>(plane, p), sign_of(nx * px + ny * py + nz * pz + d));
              }
  return count;
}

/// The largest relative errors: products and sums that just fall below a binade's middle, cancelled by the offset.
Count ordinary() {
  const std::vector<double> full{17.0 / 32, 19.0 / 32, 21.0 / 32, 23.0 / 32, 25.0 / 32, 27.0 / 32};
  const std::vector<double> some{17.0 / 32, 19.0 / 32, 23.0 / 32};
  return planes({full, some, some, window<Five>(31, -4)}, {full, some, {0.5, 17.0 / 32}, {}});
}

/// Where factors are subnormal and the others at the guard; where products underflow; at the guard and beyond it; where
/// the largest subnormal is read as zero beside the least normal number, which alone is left of the normal.
Count extreme() {
  const std::vector<double> least = window<Five>(3, low - 5), large{0.5, 1.75, 2, 3.75},
                            small = window<Five>(2, low / 2 - 2);
  return planes({least, least, least, window<Five>(8, low - 4)}, {large, large, large, {}}) +
         planes({large, large, large, window<Five>(8, low - 4)}, {least, least, least, {}}) +
         planes({small, small, small, window<Five>(6, low - 5)}, {small, small, small, {}}) +
         planes({{3, 4}, {-3.75, 4}, {-4, 2}, window<Five>(6, high - 2)}, {{3.75, 4, 8}, {4, 5}, {1, 4}, {}}) +
         planes({{std::ldexp(15, low - 4)}, {std::ldexp(1, low)}, {0}, window<Five>(31, low - 3)},
                {{2, 3.75}, {0}, {0}, {}});
}

/// Zero normals: whatever the offset, the filter knows nothing.
Count zero_normals() {
  const std::vector<double> none{0};
  return planes({none, none, none, window<Five>(20, -2)}, {window<Five>(2, -1), none, none, {}});
}

}  // namespace

TEST_CASE("toy floats: no certain side of a plane is wrong") {
  for (int rounding = 0; rounding < 4; ++rounding) {
    Five::set({rounding, false, false});
    const Count count = ordinary();
    CHECK(count.wrong == 0);
    CHECK(count.certain > count.cases / 20);
  }
  CHECK(in_all_environments<Five>(extreme).wrong == 0);
  CHECK(in_all_environments<Five>(zero_normals).certain == 0);
}

TEST_CASE("toy floats: a bound of a plane that is too small is found out") {
  {
    const Weakened<Format> weakened(1.0 / 32, 1);
    Five::set({2, false, false});
    CHECK(ordinary().wrong > 0);
  }
  const Weakened<Format> weakened(1, 0);
  CHECK(in_all_environments<Five>(extreme).wrong > 0);
}

}  // namespace touchstone::proptests
