// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "catalogue/families/choices.h"
#include "oracle/exact/elimination.h"
#include "proptests/machine/robust/toy_windows.h"

// The filters of two segments, and of a ray and a segment, on all inputs whose coordinates come from a set of toy
// numbers, in every environment.
namespace touchstone::proptests {
namespace {

namespace filters = robust::filters;
using filters::Sign;

constexpr int low = -20, high = 7, unit = -5;
using Five = Toy<5, low, high>;
using Format = ToyFormat<Five, 5, low, high>;
using Whole = std::int64_t;

/// Four coordinates along one axis.
using Axis = std::array<int, 4>;

/// One representative for every triple of differences from the first coordinate and of the last two: for all that the
/// filters see.
std::vector<Axis> axes(const std::vector<int>& numbers) {
  std::vector<Axis> made;
  std::set<std::array<int, 3>> seen;
  for (const int a : numbers) {
    for (const int b : numbers) {
      for (const int c : numbers) {
        for (const int d : numbers) {
          if (seen.insert({b - a, d - c, a - c}).second) made.push_back({a, b, c, d});
        }
      }
    }
  }
  return made;
}

Five toy(int k) { return Five::of(std::ldexp(k, unit)); }

Count segments(const std::vector<int>& numbers) {
  Count count;
  const auto all = axes(numbers);
  for (const Axis& x : all) {
    for (const Axis& y : all) {
      const Sign said = filters::segments<Five, Format>({{toy(x[0]), toy(y[0])}, {toy(x[1]), toy(y[1])}},
                                                        {{toy(x[2]), toy(y[2])}, {toy(x[3]), toy(y[3])}});
      ++count.cases;
      if (said == Sign::unknown) continue;
      ++count.certain;
      const auto truth =
          oracle::segment_segment_relation<Whole, Whole>({{x[0], y[0]}, {x[1], y[1]}}, {{x[2], y[2]}, {x[3], y[3]}});
      count.wrong += truth != (said == Sign::positive ? SegmentRelation::disjoint : SegmentRelation::point);
    }
  }
  return count;
}

/// How a ray (origin, direction) and a segment meet, by the sides of the segment's ends.
RayRelation relation(int ox, int oy, int vx, int vy, int ax, int ay, int bx, int by) {
  const int fx = ax - ox, fy = ay - oy, gx = bx - ox, gy = by - oy;
  const int a = vx * fy - vy * fx, b = vx * gy - vy * gx;
  const auto behind = [&](int x, int y) { return vx * x + vy * y < 0; };
  if ((a > 0 && b > 0) || (a < 0 && b < 0)) return RayRelation::none;
  if (a == 0 && b == 0) return behind(fx, fy) && behind(gx, gy) ? RayRelation::none : RayRelation::overlap;
  if (a == 0) return behind(fx, fy) ? RayRelation::none : RayRelation::point;
  if (b == 0) return behind(gx, gy) ? RayRelation::none : RayRelation::point;
  // t = (f x s) / (v x s), and v x s = b - a.
  const int fs = fx * (gy - fy) - fy * (gx - fx);
  return fs == 0 || (fs > 0) == (b > a) ? RayRelation::point : RayRelation::none;
}

Count rays(const std::vector<int>& numbers) {
  Count count;
  std::vector<Axis> all;  // origin, direction, segment's ends: the direction is no difference
  for (const int o : numbers) {
    for (const int v : numbers) {
      for (const int a : numbers) {
        for (const int b : numbers) all.push_back({o, v, a, b});
      }
    }
  }
  for (const Axis& x : all) {
    for (const Axis& y : all) {
      const Sign said = filters::ray<Five, Format>({toy(x[0]), toy(y[0])}, {toy(x[1]), toy(y[1])},
                                                   {{toy(x[2]), toy(y[2])}, {toy(x[3]), toy(y[3])}});
      ++count.cases;
      if (said == Sign::unknown) continue;
      ++count.certain;
      const RayRelation truth = relation(x[0], y[0], x[1], y[1], x[2], y[2], x[3], y[3]);
      count.wrong += truth != (said == Sign::positive ? RayRelation::none : RayRelation::point);
    }
  }
  return count;
}

/// `count` numbers of five bits up to 24 in magnitude: different ones in every set.
std::vector<int> scattered(std::uint64_t set, std::size_t count) {
  audit::Choices choices = audit::Choices::seeded(audit::seed_of(1, "toy numbers", set));
  std::set<int> numbers;
  while (numbers.size() < count) {
    const int k = static_cast<int>(choices.below(49)) - 24;
    if (Five::rounded(k, {}) == k) numbers.insert(k);
  }
  return {numbers.begin(), numbers.end()};
}

template <class Ask>
Count over_sets(std::size_t count, std::uint64_t sets, const Ask& ask) {
  Count sum;
  for (std::uint64_t set = 0; set < sets; ++set) sum = sum + ask(scattered(set, count));
  return sum;
}

}  // namespace

TEST_CASE("toy floats: what is certain of two segments, or of a ray and a segment, is never wrong") {
  const Count of_segments = in_all_environments<Five>([] {
    return segments({-2, -1, 0, 1, 2}) + over_sets(4, 6, segments);
  });
  CHECK(of_segments.wrong == 0);
  CHECK(of_segments.certain > 0);
  const Count of_rays = in_all_environments<Five>([] { return rays({-16, 0, 12, 23}) + over_sets(4, 4, rays); });
  CHECK(of_rays.wrong == 0);
  CHECK(of_rays.certain > 0);
}

TEST_CASE("toy floats: for segments and rays too, a bound that is too small is found out") {
  const Weakened<Format> weakened(1.0 / 64, 1);
  CHECK(in_all_environments<Five>([] { return over_sets(4, 6, segments); }).wrong > 0);
  CHECK(in_all_environments<Five>([] { return over_sets(4, 4, rays); }).wrong > 0);
}

}  // namespace touchstone::proptests
