// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/triangulation.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/validation.h"
#include "oracle/rings/simple.h"

namespace touchstone::oracle {
namespace {

template <class Number>
IntegerRing validated(const Polygon2<Number>& polygon) {
  validation::validate("polygon", polygon);
  IntegerRing ring(*validation::OpenRing(polygon));
  if (const auto defect = ring_defect(ring)) validation::refuse("polygon", *defect, ring.size());
  return ring;
}

}  // namespace

IntegerRing simple_ring(const Polygon2d& polygon) { return validated(polygon); }
IntegerRing simple_ring(const Polygon2<Rational>& polygon) { return validated(polygon); }

std::vector<Index> counter_clockwise(const IntegerRing& ring) {
  std::vector<Index> all(ring.size());
  std::iota(all.begin(), all.end(), Index{0});
  if (sgn(ring.area()) < 0) std::reverse(all.begin(), all.end());
  return all;
}

/// A ring of more than three vertices has a diagonal at its first vertex v in the order of the plane, where it turns
/// left. With u and w before and after v: uw if the closed triangle uvw contains no other vertex, otherwise vz to the
/// contained vertex that is farthest from uw on v's side, because no edge can reach into the part of the triangle
/// beyond z without ending there.
IndexLists triangulated(const IntegerRing& ring) {
  IndexLists triangles, rings{counter_clockwise(ring)};
  while (!rings.empty()) {
    std::vector<Index> now = std::move(rings.back());
    rings.pop_back();
    const auto first = std::min_element(now.begin(), now.end(), [&](Index i, Index j) {
      return ring[i].x < ring[j].x || (ring[i].x == ring[j].x && ring[i].y < ring[j].y);
    });
    std::rotate(now.begin(), first, now.end());
    const Index v = now[0], w = now[1], u = now.back();
    std::size_t farthest = 0;
    Integer height;
    for (std::size_t i = 2; i + 1 < now.size(); ++i) {
      const Index z = now[i];
      if (ring.turn(u, v, z) < 0 || ring.turn(v, w, z) < 0) continue;
      Integer above = ring.area(w, u, z);
      if (sgn(above) < 0 || (farthest != 0 && above <= height)) continue;
      farthest = i, height = std::move(above);
    }
    if (farthest == 0) {
      triangles.push_back({u, v, w});
      now.erase(now.begin());
      if (now.size() > 2) rings.push_back(std::move(now));
      continue;
    }
    const auto z = now.begin() + static_cast<std::ptrdiff_t>(farthest);
    std::vector<Index> rest(z, now.end());
    rest.push_back(v);
    rings.emplace_back(now.begin(), z + 1);
    rings.push_back(std::move(rest));
  }
  return triangles;
}

Truth<IndexLists> cut(IntegerRing ring, IndexLists pieces) {
  Integer least = abs(ring.area(ring.before(0), 0, ring.after(0)));
  for (Index i = 1; i < ring.size(); ++i)
    least = std::min(least, Integer(abs(ring.area(ring.before(i), i, ring.after(i)))));
  Rational margin = ring.actual_area(Rational(least));
  return {std::move(pieces), std::move(margin), [ring = std::move(ring)] {
            return Certificate{"pieces", {{"doubled_area", {ring.actual_area(Rational(abs(ring.area())))}}}};
          }};
}

}  // namespace touchstone::oracle
