// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "geometry/validation.h"
#include "oracle/rings/triangulation.h"

/// The definition, part by part: every piece is a convex ring of vertices of the polygon, their interiors are disjoint,
/// their areas add up to that of the polygon, and their other edges are inside the polygon.
///
/// No defect passes. An edge inside the polygon keeps every piece inside it; disjoint pieces inside it with its total
/// area are all of it.
namespace touchstone::oracle {
namespace {

std::string named(const char* what, std::size_t i) { return what + (" " + std::to_string(i)); }

std::string indices_defect(const IntegerRing& ring, const IndexLists& pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].size() < 3) return named("fewer than three vertices in piece", i);
    for (const Index k : pieces[i]) {
      if (k >= ring.size()) return named("no such vertex:", k);
    }
    if (std::set<Index>(pieces[i].begin(), pieces[i].end()).size() != pieces[i].size())
      return named("a vertex twice in piece", i);
  }
  return "";
}

/// True if every vertex is on the left of every edge or on it, and not all are collinear. (Then each edge lies on the
/// hull's boundary in its direction, and different vertices cannot make two turns.)
bool convex(const IntegerRing& ring, const std::vector<Index>& piece) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Index p = piece[i], q = piece[(i + 1) % piece.size()];
    bool beside = false;
    for (const Index r : piece) {
      const int turn = ring.turn(p, q, r);
      if (turn < 0) return false;
      beside = beside || turn > 0;
    }
    if (!beside) return false;
  }
  return true;
}

/// True if an edge of a has all of b on its right or on it: for convex pieces, if it separates their interiors.
bool parted(const IntegerRing& ring, const std::vector<Index>& a, const std::vector<Index>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Index p = a[i], q = a[(i + 1) % a.size()];
    if (std::all_of(b.begin(), b.end(), [&](Index r) { return ring.turn(p, q, r) <= 0; })) return true;
  }
  return false;
}

bool on_segment(const IntegerRing& ring, Index a, Index b, Index p) {
  const auto &s = ring[a], &t = ring[b], &r = ring[p];
  return ring.turn(a, b, p) == 0 && std::min(s.x, t.x) <= r.x && r.x <= std::max(s.x, t.x) &&
         std::min(s.y, t.y) <= r.y && r.y <= std::max(s.y, t.y);
}

/// True if the open segment from vertex a to vertex b, not an edge, lies inside the ring, which is simple: it starts
/// within the angle at a, no edge that does not end in a or b meets it, and no neighbour of a or b lies on it.
bool diagonal(const IntegerRing& ring, Index a, Index b, bool counter_clockwise) {
  const Index next = counter_clockwise ? ring.after(a) : ring.before(a),
              last = counter_clockwise ? ring.before(a) : ring.after(a);
  const bool left_of_next = ring.turn(a, next, b) > 0, right_of_last = ring.turn(a, last, b) < 0;
  if (ring.turn(last, a, next) > 0 ? !(left_of_next && right_of_last) : !(left_of_next || right_of_last)) return false;
  for (Index i = 0; i < ring.size(); ++i) {
    const Index j = ring.after(i);
    if (i != a && i != b && on_segment(ring, a, b, i)) return false;
    if (i == a || i == b || j == a || j == b) continue;
    if (ring.turn(a, b, i) * ring.turn(a, b, j) < 0 && ring.turn(i, j, a) * ring.turn(i, j, b) <= 0) return false;
  }
  return true;
}

std::string edges_defect(const IntegerRing& ring, const IndexLists& pieces, bool counter_clockwise) {
  std::set<std::pair<Index, Index>> inside;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = 0; k < pieces[i].size(); ++k) {
      const Index p = pieces[i][k], q = pieces[i][(k + 1) % pieces[i].size()];
      if (q == (counter_clockwise ? ring.after(p) : ring.before(p))) continue;
      if (inside.insert(std::minmax(p, q)).second && !diagonal(ring, p, q, counter_clockwise)) {
        return named("an edge not inside the polygon in piece", i);
      }
    }
  }
  return "";
}

}  // namespace

std::string partition_defect(const Polygon2d& polygon, const IndexLists& pieces) {
  const IntegerRing ring(*validation::OpenRing(polygon));
  const std::string indices = indices_defect(ring, pieces);
  if (!indices.empty()) return indices;
  Integer area;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!convex(ring, pieces[i])) return named("not convex, counter-clockwise and of positive area: piece", i);
    area += ring.area(pieces[i]);
  }
  const Integer whole = ring.area();
  if (area != abs(whole)) return "the areas do not add up to the polygon's";
  const std::string edges = edges_defect(ring, pieces, sgn(whole) > 0);
  if (!edges.empty()) return edges;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!parted(ring, pieces[i], pieces[k]) && !parted(ring, pieces[k], pieces[i])) {
        return named("interiors meet: pieces", k) + named(" and", i);
      }
    }
  }
  return "";
}

}  // namespace touchstone::oracle
