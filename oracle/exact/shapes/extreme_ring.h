// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// The extreme points of points in a plane, counter-clockwise from the least: both ends if they are collinear, one if
/// they are equal. Equal points are represented by the first. before(p, q): the lexicographic order. area(p, q, r):
/// twice the area of a triangle, positive if it turns left.
///
/// The first and the last point are extreme, and so is the one farthest from the line through two extreme points, of
/// several the first: it divides those beyond the line into those beyond each of two lines, and others that are not
/// extreme.
template <class Before, class Area>
std::vector<Index> extreme_ring(const std::vector<Index>& points, const Before& before, const Area& area) {
  struct Beyond {
    Index to;
    std::vector<Index> points;
  };
  const auto [first, last] = std::pair{*std::min_element(points.begin(), points.end(), before),
                                       *std::max_element(points.begin(), points.end(), before)};
  std::vector<Index> ring{first};
  if (!before(first, last)) return ring;
  std::vector<Beyond> rest{{first, points}, {last, points}};
  while (!rest.empty()) {
    const Index from = ring.back();
    Beyond& next = rest.back();
    std::vector<Index> outside;
    Index farthest = next.to;
    Integer least(0);
    for (const Index p : next.points) {
      Integer here = area(from, next.to, p);
      if (sgn(here) >= 0) continue;
      outside.push_back(p);
      if (here < least || (here == least && before(p, farthest))) farthest = p, least = std::move(here);
    }
    if (!outside.empty()) {
      next.points = outside;
      rest.push_back({farthest, std::move(outside)});
      continue;
    }
    if (next.to != first) ring.push_back(next.to);
    rest.pop_back();
  }
  return ring;
}

/// A point to the right of an edge of a ring that turns left at each of its corners, which are different points;
/// nullopt if there is none among the points 0 to count - 1. turn(p, q, r): the sign of that area.
///
/// A ring that ascends from its least corner to its greatest and then descends goes round once, so it is convex: a
/// point between these corners is inside if it is inside of both edges between whose ends it is in the order. Another
/// ring has a corner to the right of an edge, as no convex ring turns so.
template <class Before, class Turn>
std::optional<Index> point_outside(std::vector<Index> ring, Index count, const Before& before, const Turn& turn) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), before), ring.end());
  ring.push_back(ring[0]);
  const auto descending = [&](Index p, Index q) { return before(q, p); };
  const auto top = std::max_element(ring.begin(), ring.end(), before);
  if (!std::is_sorted(ring.begin(), top + 1, before) || !std::is_sorted(top, ring.end(), descending)) {
    for (const Index p : ring)
      for (std::size_t k = 1; k < ring.size(); ++k)
        if (turn(ring[k - 1], ring[k], p) < 0) return p;
  }
  const auto outside = [&](auto begin, auto end, Index p, const auto& earlier) {
    const auto next = std::lower_bound(begin, end, p, earlier);
    if (next == begin) return earlier(p, *next);
    return next == end || turn(*(next - 1), *next, p) < 0;
  };
  for (Index p = 0; p < count; ++p)
    if (outside(ring.begin(), top + 1, p, before) || outside(top, ring.end(), p, descending)) return p;
  return std::nullopt;
}

}  // namespace touchstone::oracle
