// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "oracle/certificates/check_rings.h"

namespace touchstone::certify {
namespace {

/// The edges of all rings of a shape.
using Edges = std::vector<Ends>;

/// y of the edge at x; the edge is not vertical.
Rational height(const Ends& e, const Rational& x) {
  return Rational(e.a.y + (x - e.a.x) / (e.b.x - e.a.x) * (e.b.y - e.a.y));
}

bool spans(const Ends& e, const Rational& left, const Rational& right) {
  return std::min(e.a.x, e.b.x) <= left && std::max(e.a.x, e.b.x) >= right;
}

Edges spanning(const Edges& edges, const Rational& left, const Rational& right) {
  Edges found;
  for (const Ends& e : edges) {
    if (spans(e, left, right)) found.push_back(e);
  }
  return found;
}

/// Requires that an odd number of edges is above p, none of them through p, and no vertex straight above or below p.
void expect_inside(const Edges& edges, const Pair& p) {
  std::size_t above = 0;
  for (const Ends& e : edges) {
    expect(e.a.x != p.x, "certificate: a vertex is straight above or below the point");
    if ((e.a.x < p.x) == (e.b.x < p.x)) continue;
    const Rational y = height(e, p.x);
    expect(y != p.y, "certificate: the point is on a boundary");
    above += y > p.y;
  }
  expect(above % 2 == 1, "certificate: the point is not inside");
}

bool on_edge(const Ends& e, const Pair& p) { return meet(e, {p, p}); }

bool on_boundary(const Edges& edges, const Pair& p) {
  return std::any_of(edges.begin(), edges.end(), [&p](const Ends& e) { return on_edge(e, p); });
}

/// Between two cuts no edge of a crosses one of b, so the middle line represents the entire slab: there the intervals
/// of a and those of b, from one edge to the next, have no common inside.
void expect_apart_in_slab(const Edges& a, const Edges& b, const Rational& left, const Rational& right) {
  const Edges of_a = spanning(a, left, right), of_b = spanning(b, left, right);
  for (const Ends& e : of_a) {
    for (const Ends& f : of_b) {
      const int before = cmp(height(e, left), height(f, left)), after = cmp(height(e, right), height(f, right));
      expect(before * after >= 0, "certificate: edges cross inside a slab");
    }
  }
  const Rational middle = (left + right) / 2;
  const auto heights = [&middle](const Edges& edges) {
    std::vector<Rational> found;
    for (const Ends& e : edges) found.push_back(height(e, middle));
    std::sort(found.begin(), found.end());
    return found;
  };
  const std::vector<Rational> low_a = heights(of_a), low_b = heights(of_b);
  for (std::size_t i = 0; i + 1 < low_a.size(); i += 2) {
    for (std::size_t j = 0; j + 1 < low_b.size(); j += 2) {
      expect(low_a[i + 1] <= low_b[j] || low_b[j + 1] <= low_a[i], "truth: the polygons overlap in a slab");
    }
  }
}

void expect_no_overlap(const Edges& a, const Edges& b, const std::vector<Rational>& cuts) {
  for (const Edges* edges : {&a, &b}) {
    for (const Ends& e : *edges) {
      expect(std::find(cuts.begin(), cuts.end(), e.a.x) != cuts.end(), "certificate: no cut at a vertex");
    }
  }
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    expect(cuts[i] < cuts[i + 1], "certificate: the cuts do not ascend");
    expect_apart_in_slab(a, b, cuts[i], cuts[i + 1]);
  }
}

void check_contact(const Claim& claim, const Edges& a, const Edges& b) {
  claim.answers({"contact"});
  const std::string contact = claim.word("contact");
  if (contact == "overlapping") {
    claim.expect_kind("common_interior_point");
    claim.facts({"point"});
    const Pair p = claim.pair("point");
    expect_inside(a, p), expect_inside(b, p);
    return;
  }
  expect(contact == "touching" || contact == "disjoint", "truth: contact is wrong");
  claim.expect_kind("slabs");
  contact == "touching" ? claim.facts({"cuts", "point"}) : claim.facts({"cuts"});
  expect_no_overlap(a, b, claim.list("cuts"));
  if (contact == "touching") {
    const Pair p = claim.pair("point");
    expect(on_boundary(a, p) && on_boundary(b, p), "certificate: the point is not on both boundaries");
    return;
  }
  for (const Ends& e : a) {
    for (const Ends& f : b) expect(!meet(e, f), "truth: the boundaries meet");
  }
}

void check_polygon_polygon(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Ring a = polygon(claim.input["a"], "a");
  expect_simple(a, "a");
  const Ring b = polygon(claim.input["b"], "b");
  expect_simple(b, "b");
  check_contact(claim, edges_of({a}), edges_of({b}));
}

void check_region_region(const Claim& claim) {
  claim.inputs({"a", "b"});
  const std::vector<Ring> a = region(claim.input["a"], "a"), b = region(claim.input["b"], "b");
  check_contact(claim, edges_of(a), edges_of(b));
}

}  // namespace

Checks checks_of_overlap() {
  return {{"polygon_polygon", check_polygon_polygon}, {"region_region", check_region_region}};
}

}  // namespace touchstone::certify
