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

}  // namespace

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

std::size_t vertex(const Rational& index, const Ring& ring) {
  expect(index.get_den() == 1 && sgn(index) >= 0 && index < static_cast<std::uint64_t>(ring.size()),
         "certificate: not an index");
  return index.get_num().get_ui();
}

}  // namespace touchstone::certify
