// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "oracle/certificates/check_circular.h"
#include "oracle/certificates/check_rings.h"
#include "oracle/certificates/check_rounding.h"

namespace touchstone::certify {
namespace {

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
  expect(i < j && sgn(at.x) >= 0 && at.x <= 1 && sgn(at.y) >= 0 && at.y <= 1,
         "certificate: not two edges and a point of each");
  const Pair p = along(a.a, at.x, a.b - a.a);
  expect(p == along(b.a, at.y, b.b - b.a), "certificate: the points differ");
  expect(!(j == i + 1 && p == b.a) && !(i == 0 && j == ring.size() - 1 && p == a.a),
         "certificate: neighbours share this vertex");
}

/// That the ring is simple is part of the truth here, not a rule for the input.
void expect_simple_as_claimed(const Ring& ring) {
  expect_not_degenerate(ring);
  expect(!defect(ring), "truth: two edges meet");
}

void check_concave(const Claim& claim, const Ring& ring) {
  expect_simple_as_claimed(ring);
  expect_truth(claim, "concave", false, winding(ring)), claim.facts({"edge", "vertices"});
  const Ends e = edge(ring, vertex(claim.single("edge"), ring));
  const Pair vertices = claim.pair("vertices");
  const int left = side(e, ring[vertex(vertices.x, ring)]), right = side(e, ring[vertex(vertices.y, ring)]);
  expect(left > 0 && right < 0, "certificate: the vertices are not on different sides");
}

void check_convex(const Claim& claim, const Ring& ring) {
  expect_simple_as_claimed(ring);
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
  claim.inputs({"polygon"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  claim.answers({"class", "strict", "orientation"});
  const std::string kind = claim.kind();
  if (kind == "repeated_neighbour" || kind == "common_line") return check_degenerate(claim, ring);
  if (kind == "common_point") return check_not_simple(claim, ring);
  if (kind == "both_sides") return check_concave(claim, ring);
  expect(kind == "one_side", wrong_kind);
  check_convex(claim, ring);
}

/// 1, -1: the vector lies counter-clockwise or clockwise of the angle u, by less than half a turn; 0 if the bits do not
/// decide.
int turn_from(const Rational& u, const Pair& vector, std::int64_t bits) {
  const Rational turns(u * 7 / 11 + Rational(1, 2));  // about 2 / pi
  const auto [cosine, sine] = cosine_and_sine(u, mpz_class(turns.get_num() / turns.get_den()), bits);
  // y cos u - x sin u
  const bool up = sgn(vector.y) >= 0, ahead = sgn(vector.x) >= 0;
  const Rational low(vector.y * (up ? cosine.low : cosine.high) - vector.x * (ahead ? sine.high : sine.low));
  const Rational high(vector.y * (up ? cosine.high : cosine.low) - vector.x * (ahead ? sine.low : sine.high));
  return sgn(low) > 0 ? 1 : sgn(high) < 0 ? -1 : 0;
}

/// Requires that the angle in (0, 2 pi) of a vector, not along +x, lies between low and high: it is less than half a
/// turn beyond low, and high less than half a turn beyond it; and they are on the vector's side of the x axis, or
/// nearly, which excludes full turns.
void expect_angle(const Pair& vector, const Rational& low, const Rational& high, std::int64_t bits) {
  const char* const reason = "certificate: an angle is not between low and high";
  expect(sgn(low) > 0 && low < high && high - low < 1, reason);
  expect(sgn(vector.y) < 0 ? low > 3 && high < 7 : high < 4, reason);
  expect(turn_from(low, vector, bits) > 0 && turn_from(high, vector, bits) < 0, reason);
}

void check_interior_angles(const Claim& claim) {
  claim.inputs({"polygon"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  expect_simple(ring, "polygon");
  claim.answers({"angles"});
  claim.expect_kind("enclosure"), claim.facts({"low", "high", "bits"});
  const std::vector<Rational> low = claim.list("low"), high = claim.list("high");
  const json& angles = claim.truth["angles"];
  const std::size_t n = ring.size();
  expect(angles.is_array() && angles.size() == n, "truth.angles: one for each vertex");
  expect(low.size() == n && high.size() == n, "certificate: low and high for each vertex");
  const std::int64_t bits = integer_bits(claim.single("bits"));
  const bool ccw = std::string(winding(ring)) == "ccw";
  for (std::size_t i = 0; i < n; ++i) {
    const Pair next = ring[(i + 1) % n] - ring[i], previous = ring[(i + n - 1) % n] - ring[i];
    const Rational turn = cross(next, previous);
    expect_angle({dot(next, previous), ccw ? turn : Rational(-turn)}, low[i], high[i], bits);
    const Rational angle = exact_value(angles[i], "truth.angles[" + std::to_string(i) + "]");
    expect(low[i] < angle && angle < high[i], "truth: an angle is not between low and high");
    expect_rounds_alike("angles", angle, low[i], high[i]);
  }
}

}  // namespace

Checks checks_of_convexity() {
  return {{"polygon_convexity", check_polygon_convexity},
          {"polygon_convexity_interior_angles", check_polygon_convexity},
          {"interior_angles", check_interior_angles}};
}

}  // namespace touchstone::certify
