// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_rings.h"

#include <algorithm>

namespace touchstone::certify {
namespace {

bool beside(const Ends& a, const Ends& b) { return side(a, b.a) * side(a, b.b) > 0; }

bool beyond(const Ends& a, const Ends& b) {
  return std::max(a.a.x, a.b.x) < std::min(b.a.x, b.b.x) || std::max(a.a.y, a.b.y) < std::min(b.a.y, b.b.y);
}

}  // namespace

Ends edge(const Ring& ring, std::size_t i) { return {ring[i], ring[(i + 1) % ring.size()]}; }

int side(const Ends& line, const Pair& p) { return sgn(cross(line.b - line.a, p - line.a)); }

bool meet(const Ends& a, const Ends& b) { return !(beside(a, b) || beside(b, a) || beyond(a, b) || beyond(b, a)); }

void expect_not_degenerate(const Ring& ring) {
  bool turns = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e = edge(ring, i);
    expect(!(e.a == e.b), "truth: neighbours are one point");
    turns = turns || side(e, edge(ring, (i + 1) % ring.size()).b) != 0;
  }
  expect(turns, "truth: all vertices are on one line");
}

void expect_simple(const Ring& ring) {
  expect_not_degenerate(ring);
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Ends e = edge(ring, i), next = edge(ring, (i + 1) % n);
    expect(side(e, next.b) != 0 || sgn(dot(e.b - e.a, next.b - next.a)) > 0, "truth: the polygon turns back on itself");
    for (std::size_t j = i + 2; j < n && !(i == 0 && j == n - 1); ++j) {
      expect(!meet(e, edge(ring, j)), "truth: two edges meet");
    }
  }
}

std::size_t vertex(const Rational& index, const Ring& ring) {
  expect(index.get_den() == 1 && sgn(index) >= 0 && index < static_cast<unsigned long>(ring.size()),
         "certificate: not an index");
  return index.get_num().get_ui();
}

}  // namespace touchstone::certify
