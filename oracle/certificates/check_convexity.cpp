// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "oracle/certificates/check_rings.h"

namespace touchstone::certify {
namespace {

const char* const wrong_kind = "certificate: no such kind for this truth";

void expect_truth(const Claim& claim, const char* name, bool strict, const char* orientation) {
  expect(claim.word("class") == name, wrong_kind);
  expect(claim.truth["strict"].is_boolean(), "truth: field strict is missing");
  expect(claim.truth["strict"].get<bool>() == strict, "truth: strict is wrong");
  expect(claim.word("orientation") == orientation, "truth: orientation is wrong");
}

/// The direction of a simple ring, by the trapezoids under its edges.
const char* winding(const Ring& ring) {
  Rational sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e = edge(ring, i);
    sum += (e.a.x - e.b.x) * (e.a.y + e.b.y);
  }
  return sgn(sum) > 0 ? "ccw" : "cw";
}

void check_degenerate(const Claim& claim, const Ring& ring) {
  expect_truth(claim, "degenerate", false, "none");
  if (claim.kind() == "repeated_neighbour") {
    claim.facts({"vertex"});
    const Ends e = edge(ring, vertex(claim.single("vertex"), ring));
    expect(e.a == e.b, "certificate: these neighbours differ");
    return;
  }
  claim.facts({"normal", "offset"});
  const Pair normal = claim.pair("normal");
  const Rational offset = claim.single("offset");
  expect(sgn(normal.x) != 0 || sgn(normal.y) != 0, "certificate: normal is zero");
  for (const Pair& p : ring) expect(dot(normal, p) == offset, "certificate: a vertex is not on the line");
}

void check_not_simple(const Claim& claim, const Ring& ring) {
  expect_truth(claim, "not_simple", false, "none"), claim.facts({"edges", "parameters"});
  expect_not_degenerate(ring);
  const Pair edges = claim.pair("edges"), at = claim.pair("parameters");
  const std::size_t i = vertex(edges.x, ring), j = vertex(edges.y, ring);
  const Ends a = edge(ring, i), b = edge(ring, j);
  expect(i < j && sgn(at.x) >= 0 && at.x <= 1 && sgn(at.y) >= 0 && at.y <= 1, "certificate: not two edges and a point of each");
  const Pair p = along(a.a, at.x, a.b - a.a);
  expect(p == along(b.a, at.y, b.b - b.a), "certificate: the points differ");
  expect(!(j == i + 1 && p == b.a) && !(i == 0 && j == ring.size() - 1 && p == a.a), "certificate: neighbours share this vertex");
}

void check_concave(const Claim& claim, const Ring& ring) {
  expect_simple(ring);
  expect_truth(claim, "concave", false, winding(ring)), claim.facts({"edge", "vertices"});
  const Ends e = edge(ring, vertex(claim.single("edge"), ring));
  const Pair vertices = claim.pair("vertices");
  const int left = side(e, ring[vertex(vertices.x, ring)]), right = side(e, ring[vertex(vertices.y, ring)]);
  expect(left > 0 && right < 0, "certificate: the vertices are not on different sides");
}

void check_convex(const Claim& claim, const Ring& ring) {
  expect_simple(ring);
  claim.facts({"doubled_area"});
  const Rational area = claim.single("doubled_area");
  bool strict = true;
  Rational sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e = edge(ring, i);
    sum += cross(e.a, e.b);
    for (const Pair& p : ring) expect(side(e, p) * sgn(area) >= 0, "truth: a vertex is on the wrong side of an edge");
    strict = strict && side(e, edge(ring, (i + 1) % ring.size()).b) != 0;
  }
  expect(area == sum, "certificate: the doubled area is wrong");
  expect_truth(claim, "convex", strict, winding(ring));
}

void check_polygon_convexity(const Claim& claim) {
  claim.inputs({"polygon"}), claim.answers({"class", "strict", "orientation"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  const std::string kind = claim.kind();
  if (kind == "repeated_neighbour" || kind == "common_line") return check_degenerate(claim, ring);
  if (kind == "common_point") return check_not_simple(claim, ring);
  if (kind == "both_sides") return check_concave(claim, ring);
  expect(kind == "one_side", wrong_kind);
  check_convex(claim, ring);
}

}  // namespace

Checks checks_of_convexity() {
  return {{"polygon_convexity", check_polygon_convexity}, {"polygon_convexity_interior_angles", check_polygon_convexity}};
}

}  // namespace touchstone::certify
