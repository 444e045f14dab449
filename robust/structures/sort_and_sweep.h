// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"

/// Sort and sweep: pairs of valid solids, from the order of their lower ends on one axis.
namespace touchstone::robust::structures {

/// Its type is written out: g++ for Windows puts a variable whose type it deduces into sections of different names.
inline constexpr std::array<double Point3d::*, 3> coordinates{&Point3d::x, &Point3d::y, &Point3d::z};

/// The interval of a solid on an axis: its middle and half its length, and its ends as integers.
struct Interval {
  double middle, half;
  std::int64_t low, high;
};

inline Interval interval(const Aabb3d& box, double Point3d::*axis) {
  const double low = box.min.*axis, high = box.max.*axis;
  return {0.5 * low + 0.5 * high, 0.5 * high - 0.5 * low, kernel::ordered_bits(low), kernel::ordered_bits(high)};
}

/// Rounding is monotone, and the same for all ends under a guard: intervals that meet still do, infinite ones included.
inline Interval interval(const Sphere3d& ball, double Point3d::*axis) {
  const double middle = ball.center.*axis;
  return {middle, ball.radius, kernel::ordered_bits(middle - ball.radius), kernel::ordered_bits(middle + ball.radius)};
}

using Intervals = std::array<std::vector<Interval>, 3>;

template <class Solid>
Intervals intervals_of(const std::vector<Solid>& solids) {
  const kernel::ControlWord guard;
  Intervals all;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all[axis].reserve(solids.size());
    for (const Solid& solid : solids) all[axis].push_back(interval(solid, coordinates[axis]));
  }
  return all;
}

/// An estimate of the number of others that an interval meets: half the mean length over the mean distance of a middle
/// from the mean of all. The answer does not depend on it.
inline double crowding(const std::vector<Interval>& intervals) {
  const double share = 1.0 / static_cast<double>(intervals.size());
  double mean = 0, length = 0, spread = 0;
  for (const Interval& one : intervals) mean += share * one.middle, length += share * one.half;
  for (const Interval& one : intervals) spread += share * std::abs(0.5 * one.middle - 0.5 * mean);
  return spread > 0 ? length / spread : std::numeric_limits<double>::infinity();
}

inline std::size_t least_crowded_axis(const Intervals& intervals) {
  const kernel::ControlWord guard;
  std::size_t best = 0;
  double least = crowding(intervals[0]);
  for (std::size_t axis = 1; axis < 3; ++axis) {
    const double here = crowding(intervals[axis]);
    if (here < least) best = axis, least = here;
  }
  return best;
}

/// A solid in the sweep: its ends on the axis of the sweep and on the two others.
struct Swept {
  std::int64_t low, high;
  std::array<std::int64_t, 2> other_low, other_high;
  Index place;
};

inline std::vector<Swept> in_order_of_sweep(const Intervals& intervals, std::size_t axis) {
  const std::vector<Interval>&along = intervals[axis], &second = intervals[(axis + 1) % 3],
        &third = intervals[(axis + 2) % 3];
  std::vector<std::pair<std::int64_t, Index>> order;
  order.reserve(along.size());
  for (std::size_t i = 0; i < along.size(); ++i) order.emplace_back(along[i].low, static_cast<Index>(i));
  std::sort(order.begin(), order.end());
  std::vector<Swept> swept;
  swept.reserve(order.size());
  for (const auto& [low, i] : order) {
    swept.push_back({low, along[i].high, {second[i].low, third[i].low}, {second[i].high, third[i].high}, i});
  }
  return swept;
}

inline bool overlap_beside(const Swept& a, const Swept& b) {
  // A single branch: the axis on which two solids are apart is unpredictable.
  return (static_cast<int>(a.other_low[0] <= b.other_high[0]) & static_cast<int>(b.other_low[0] <= a.other_high[0]) &
          static_cast<int>(a.other_low[1] <= b.other_high[1]) & static_cast<int>(b.other_low[1] <= a.other_high[1])) !=
         0;
}

/// A counting sort by one index of the pair; equal pairs keep their order.
inline std::vector<IndexPair> sorted_by(Index IndexPair::*place, const std::vector<IndexPair>& pairs,
                                        std::size_t size) {
  std::vector<std::size_t> start(size + 1);
  for (const IndexPair& pair : pairs) ++start[pair.*place + 1];
  for (std::size_t i = 1; i <= size; ++i) start[i] += start[i - 1];
  std::vector<IndexPair> result(pairs.size());
  for (const IndexPair& pair : pairs) result[start[pair.*place]++] = pair;
  return result;
}

/// The pairs whose intervals overlap on each axis and for which `meet` is true.
template <class Solid, class Meet>
std::vector<IndexPair> swept_pairs(const std::vector<Solid>& solids, const Meet& meet) {
  if (solids.size() < 2) return {};
  const Intervals intervals = intervals_of(solids);
  const std::vector<Swept> swept = in_order_of_sweep(intervals, least_crowded_axis(intervals));
  std::vector<IndexPair> pairs;
  for (auto a = swept.begin(); a != swept.end(); ++a) {
    for (auto b = a + 1; b != swept.end() && b->low <= a->high; ++b) {
      if (!overlap_beside(*a, *b)) continue;
      const auto [i, j] = std::minmax(a->place, b->place);
      if (meet(solids[i], solids[j])) pairs.push_back({i, j});
    }
  }
  return sorted_by(&IndexPair::i, sorted_by(&IndexPair::j, pairs, solids.size()), solids.size());
}

/// The pairs of valid boxes that meet, sorted.
inline std::vector<IndexPair> swept_pairs(const std::vector<Aabb3d>& boxes) {
  return swept_pairs(boxes, [](const Aabb3d&, const Aabb3d&) { return true; });
}

}  // namespace touchstone::robust::structures
