// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "oracle/certificates/check_rings.h"

namespace touchstone::certify {
namespace {

/// Requires that the listed edges are those that the ray from the point in that direction crosses, at t: no vertex is
/// on its line, so that an edge with its ends on different sides of the line meets it in one point, which is ahead or
/// behind.
void check_crossings(const Claim& claim, const std::vector<Ends>& ring, const Pair& p) {
  claim.facts({"direction", "edges", "t"});
  const Pair direction = claim.pair("direction");
  const std::vector<Rational> edges = claim.list("edges"), t = claim.list("t");
  expect(edges.size() == t.size(), "certificate: a parameter for each edge");
  for (const Ends& e : ring) {
    expect(sgn(cross(direction, e.a - p)) != 0, "certificate: the direction does not miss every vertex");
  }
  std::set<std::size_t> listed;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::size_t i = index_below(ring.size(), edges[k]);
    expect(listed.insert(i).second, "certificate: an edge is listed twice");
    expect(sgn(t[k]) > 0 && side(ring[i], along(p, t[k], direction)) == 0, "certificate: a parameter is wrong");
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Pair a = ring[i].a - p, b = ring[i].b - p;
    const int from = sgn(cross(direction, a)), to = sgn(cross(direction, b));
    expect(from == to || sgn(cross(a, b)) != 0, "certificate: the point is on an edge");
    const bool crossed = from != to && sgn(cross(a, b)) == to;
    expect(crossed == (listed.count(i) == 1), "certificate: not the edges that the ray crosses");
  }
  expect(claim.word("location") == (listed.size() % 2 == 1 ? "inside" : "outside"), "truth: location is wrong");
}

/// The location of a point among the edges of closed rings, by parity.
void check_location(const Claim& claim, const std::vector<Ends>& edges, const Pair& p) {
  claim.answers({"location"});
  if (claim.kind() == "crossings") return check_crossings(claim, edges, p);
  claim.expect_kind("on_edge"), claim.facts({"edge", "t"});
  const Ends e = edges[index_below(edges.size(), claim.single("edge"))];
  const Rational t = claim.single("t");
  expect(sgn(t) >= 0 && t <= 1 && p == along(e.a, t, e.b - e.a), "certificate: the point is not there on the edge");
  expect(claim.word("location") == "boundary", "truth: location is wrong");
}

void check_point_in_polygon(const Claim& claim) {
  claim.inputs({"polygon", "point"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  check_location(claim, edges_of({ring}), point(claim.input["point"], "point"));
}

void check_point_in_region(const Claim& claim) {
  claim.inputs({"region", "point"});
  const std::vector<Ring> rings = region(claim.input["region"], "region");
  check_location(claim, edges_of(rings), point(claim.input["point"], "point"));
}

/// Requires that the ring is not collinear, is simple, and has no turn against its orientation, the sign of the sum of
/// the trapezoids under the edges: a simple ring that turns one way only is convex.
void expect_convex(const Ring& ring, const std::string& what) {
  const std::size_t n = ring.size();
  expect_no_edge_of_length_zero(ring, what);
  std::vector<int> turns;
  Rational sum;
  for (std::size_t i = 0; i < n; ++i) {
    const Ends into = edge(ring, (i + n - 1) % n);
    turns.push_back(side(into, ring[(i + 1) % n]));
    sum += (into.a.x - into.b.x) * (into.a.y + into.b.y);
  }
  expect(std::any_of(turns.begin(), turns.end(), [](int turn) { return turn != 0; }),
         what + ": convex: vertices on one line have no inside");
  expect_simple(ring, what);
  for (std::size_t i = 0; i < n; ++i) {
    expect(turns[i] * sgn(sum) >= 0,
           what + "[" + std::to_string(i) + "]: convex: the ring must not turn against its direction");
  }
}

void check_point_in_convex_polygon(const Claim& claim) {
  claim.inputs({"polygon", "point"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  const Pair p = point(claim.input["point"], "point");
  expect_convex(ring, "polygon");
  claim.answers({"location"});
  if (claim.kind() == "separating_edge") {
    claim.facts({"edge"});
    const Ends e = edge(ring, vertex(claim.single("edge"), ring));
    bool beyond = side(e, p) != 0;
    for (const Pair& v : ring) beyond = beyond && side(e, v) * side(e, p) <= 0;
    expect(beyond, "certificate: the edge does not separate");
    expect(claim.word("location") == "outside", "truth: location is wrong");
    return;
  }
  claim.expect_kind("barycentric"), claim.facts({"corners", "weights"});
  const std::vector<Rational> corners = claim.list("corners"), weights = claim.list("weights");
  expect(corners.size() == 3 && weights.size() == 3, "certificate: three corners and their weights");
  Rational sum;
  Pair combination;
  for (std::size_t k = 0; k < 3; ++k) {
    expect(sgn(weights[k]) >= 0, "certificate: a weight is negative");
    sum += weights[k];
    combination = along(combination, weights[k], ring[vertex(corners[k], ring)]);
  }
  expect(sum == 1 && combination == p, "certificate: the weights give another point");
  bool on = false;
  for (std::size_t i = 0; i < ring.size(); ++i) on = on || side(edge(ring, i), p) == 0;
  expect(claim.word("location") == (on ? "boundary" : "inside"), "truth: location is wrong");
}

}  // namespace

Checks checks_of_polygons() {
  return {{"point_in_polygon", check_point_in_polygon},
          {"point_in_region", check_point_in_region},
          {"point_in_convex_polygon", check_point_in_convex_polygon}};
}

}  // namespace touchstone::certify
