// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/convex_partition.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"

namespace touchstone::oracle {
namespace {

bool convex(const IntegerRing& ring, const std::vector<Index>& piece) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (ring.turn(piece[i], piece[(i + 1) % piece.size()], piece[(i + 2) % piece.size()]) < 0) return false;
  }
  return true;
}

/// The two pieces as one, if they have an edge in common; empty if not.
std::vector<Index> merged(const std::vector<Index>& a, const std::vector<Index>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto at = std::find(b.begin(), b.end(), a[(i + 1) % a.size()]);
    if (at == b.end() || (at + 1 == b.end() ? b.front() : *(at + 1)) != a[i]) continue;
    std::vector<Index> one = a, other = b;  // a: from i + 1 round to i; b: from i round to i + 1
    std::rotate(one.begin(), one.begin() + static_cast<std::ptrdiff_t>((i + 1) % a.size()), one.end());
    std::rotate(other.begin(), other.begin() + (at - b.begin() + 1) % static_cast<std::ptrdiff_t>(b.size()),
                other.end());
    one.insert(one.end(), other.begin() + 1, other.end() - 1);
    return one;
  }
  return {};
}

/// Merges until no two pieces can be merged. A diagonal that is needed once stays needed, because angles only grow.
IndexLists partition(const IntegerRing& ring) {
  IndexLists pieces = triangulated(ring);
  for (bool merging = true; merging;) {
    merging = false;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t k = i + 1; k < pieces.size(); ++k) {
        std::vector<Index> both = merged(pieces[i], pieces[k]);
        if (both.empty() || !convex(ring, both)) continue;
        pieces[i] = std::move(both);
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k--));
        merging = true;
      }
    }
  }
  return pieces;
}

std::size_t reflex_vertices(const IntegerRing& ring) {
  const int direction = sgn(ring.area());
  std::size_t count = 0;
  for (Index i = 0; i < ring.size(); ++i) count += ring.turn_at(i) * direction < 0;
  return count;
}

}  // namespace

template <Exact Number>
Truth<IndexLists> convex_partition(const Polygon2<Number>& polygon) {
  IntegerRing ring = simple_ring(polygon);
  IndexLists pieces = partition(ring);
  return cut(std::move(ring), std::move(pieces));
}
template Truth<IndexLists> convex_partition(const Polygon2d&);
template Truth<IndexLists> convex_partition(const Polygon2<Rational>&);

std::string convex_partition_defect(const Polygon2d& polygon, const IndexLists& pieces) {
  if (pieces.size() > 2 * reflex_vertices(IntegerRing(*validation::OpenRing(polygon))) + 1)
    return "more than 2 r + 1 pieces for r reflex vertices";
  return partition_defect(polygon, pieces);
}

}  // namespace touchstone::oracle
