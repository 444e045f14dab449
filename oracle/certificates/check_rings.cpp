// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_rings.h"

#include <algorithm>
#include <cstdint>

namespace touchstone::certify {
namespace {

bool on_same_side(const Ends& a, const Ends& b) { return side(a, b.a) * side(a, b.b) > 0; }

bool beyond(const Ends& a, const Ends& b) {
  return std::max(a.a.x, a.b.x) < std::min(b.a.x, b.b.x) || std::max(a.a.y, a.b.y) < std::min(b.a.y, b.b.y);
}

/// True if an edge and the next have more in common than the vertex between them; neither has length zero.
bool turns_back(const Ends& e, const Ends& next) {
  return side(e, next.b) == 0 && sgn(dot(e.b - e.a, next.b - next.a)) < 0;
}

/// Edges of two rings that cross, or have a piece in common.
bool cross_or_coincide(const Ring& a, const Ring& b) {
  for (const Ends& e : edges_of({a})) {
    for (const Ends& f : edges_of({b})) {
      const int at_a = side(e, f.a), at_b = side(e, f.b);
      if (at_a * at_b < 0 && side(f, e.a) * side(f, e.b) < 0) return true;
      if (at_a != 0 || at_b != 0) continue;
      const Pair v = e.b - e.a;
      const Rational s = dot(f.a - e.a, v), t = dot(f.b - e.a, v);
      if (std::max(Rational(0), std::min(s, t)) < std::min(dot(v, v), std::max(s, t))) return true;
    }
  }
  return false;
}

/// By the edges above p, which is on none.
bool within(const Ring& ring, const Pair& p) {
  bool inside = false;
  for (const Ends& e : edges_of({ring})) {
    if ((e.a.x < p.x) != (e.b.x < p.x)) inside ^= (side(e, p) > 0) == (e.a.x > e.b.x);
  }
  return inside;
}

/// The middle of every piece of a ring between vertices of the other is inside the other, or outside.
bool runs(const Ring& ring, const Ring& other, bool inside) {
  for (const Ends& e : edges_of({ring})) {
    const Pair v = e.b - e.a;
    std::vector<Rational> cuts{Rational(0), Rational(1)};
    for (const Pair& p : other) {
      if (side(e, p) == 0) cuts.push_back(std::clamp(Rational(dot(p - e.a, v) / dot(v, v)), Rational(0), Rational(1)));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] < cuts[i + 1] && within(other, along(e.a, (cuts[i] + cuts[i + 1]) / 2, v)) != inside) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Ends> edges_of(const std::vector<Ring>& rings) {
  std::vector<Ends> edges;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back(edge(ring, i));
  return edges;
}

Ends edge(const Ring& ring, std::size_t i) { return {ring[i], ring[(i + 1) % ring.size()]}; }

int side(const Ends& line, const Pair& p) { return sgn(cross(line.b - line.a, p - line.a)); }

bool meet(const Ends& a, const Ends& b) {
  return !(on_same_side(a, b) || on_same_side(b, a) || beyond(a, b) || beyond(b, a));
}

void expect_not_degenerate(const Ring& ring) {
  bool turns = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e = edge(ring, i);
    expect(!(e.a == e.b), "truth: neighbours are one point");
    turns = turns || side(e, edge(ring, (i + 1) % ring.size()).b) != 0;
  }
  expect(turns, "truth: all vertices are on one line");
}

std::optional<std::pair<std::size_t, std::size_t>> defect(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (edge(ring, i).a == edge(ring, i).b) return std::pair{i, i};
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Ends e = edge(ring, i);
    for (std::size_t j = i + 1; j < n; ++j) {
      const Ends other = edge(ring, j);
      const bool next = j == i + 1, previous = i == 0 && j == n - 1;
      const bool meeting = next ? turns_back(e, other) : previous ? turns_back(other, e) : meet(e, other);
      if (meeting) return std::pair{i, j};
    }
  }
  return std::nullopt;
}

void expect_no_edge_of_length_zero(const Ring& ring, const std::string& what) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e = edge(ring, i);
    const std::string next = std::to_string((i + 1) % ring.size());
    expect(!(e.a == e.b), numbered(what, i) + ": different from vertex " + next + ": drop one of the two");
  }
}

void expect_simple(const Ring& ring, const std::string& what) {
  expect_no_edge_of_length_zero(ring, what);
  if (const auto found = defect(ring)) {
    throw Refusal(what + "[" + std::to_string(found->first) + "]: simple: its edge must not meet edge " +
                  std::to_string(found->second));
  }
}

std::size_t index_below(std::size_t count, const Rational& index) {
  expect(index.get_den() == 1 && sgn(index) >= 0 && index < static_cast<std::uint64_t>(count),
         "certificate: not an index");
  return index.get_num().get_ui();
}
std::size_t vertex(const Rational& index, const Ring& ring) { return index_below(ring.size(), index); }

std::vector<Ring> region(const json& value, const std::string& what) {
  only(value, what, {"outer", "holes"});
  expect(value["holes"].is_array(), what + ".holes: a list of rings");
  std::vector<std::string> names{what + ".outer"};
  std::vector<Ring> rings{polygon(value["outer"], names[0])};
  for (const json& hole : value["holes"]) {
    names.push_back(numbered(what + ".holes", rings.size() - 1));
    rings.push_back(polygon(hole, names.back()));
  }
  for (std::size_t i = 0; i < rings.size(); ++i) expect_simple(rings[i], names[i]);
  for (std::size_t i = 1; i < rings.size(); ++i) {
    expect(!cross_or_coincide(rings[i], rings[0]) && runs(rings[i], rings[0], true),
           names[i] + ": inside the outer ring, which it may touch in single points only");
    for (std::size_t j = 1; j < i; ++j) {
      expect(!cross_or_coincide(rings[i], rings[j]) && runs(rings[i], rings[j], false) &&
                 runs(rings[j], rings[i], false),
             names[i] + ": outside hole " + std::to_string(j - 1) + ", which it may touch in single points only");
    }
  }
  return rings;
}

}  // namespace touchstone::certify
