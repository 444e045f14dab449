// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "oracle/certificates/check_space.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

/// The number called `name` is height / sqrt(squared_length).
void expect_root(const std::string& name, const Surd& claimed, const Rational& height, const Rational& squared_length) {
  const Rational square_of_height(height * height);
  expect(sign(claimed) == sgn(height) && sign(square(claimed) * squared_length + Rational(-square_of_height)) == 0,
         "truth: " + name + " is wrong");
}

void check_point_ground_plane(const Claim& claim) {
  claim.inputs({"point"});
  const Triple p = point_in_space(claim.input["point"], "point");
  claim.answers({"side"});
  claim.expect_kind("height"), claim.facts({"height"});
  const Rational height = claim.single("height");
  expect(height == p.y, "certificate: the height is wrong");
  expect(claim.word("side") == (sgn(height) < 0 ? "below" : sgn(height) > 0 ? "above" : "on"), "truth: side is wrong");
}

/// The sum of p x q over the edges p, q of the ring.
Triple newell_sum(const std::vector<Triple>& ring) {
  Triple sum{0, 0, 0};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Triple &p = ring[i], &q = ring[(i + 1) % ring.size()];
    sum.x += p.y * q.z - p.z * q.y;
    sum.y += p.z * q.x - p.x * q.z;
    sum.z += p.x * q.y - p.y * q.x;
  }
  return sum;
}

void check_polygon_normal(const Claim& claim) {
  claim.inputs({"polygon"});
  const Triple normal = newell_sum(polygon_in_space(claim.input["polygon"], "polygon"));
  const Rational length = dot(normal, normal);
  if (claim.word("class") == "degenerate") {
    claim.answers({"class"}), claim.expect_kind("no_area"), claim.facts({});
    expect(sgn(length) == 0, "truth: class is wrong");
    return;
  }
  expect(claim.word("class") == "proper" && sgn(length) != 0, "truth: class is wrong");
  claim.answers({"class", "normal", "unit"});
  expect(exact_triple(claim.truth["normal"], "truth.normal") == normal, "truth: normal is wrong");
  const json& unit = claim.truth["unit"];
  expect(unit.is_array() && unit.size() == 3, "truth.unit: a list of three");
  const std::array<Rational, 3> parts{normal.x, normal.y, normal.z};
  for (std::size_t i = 0; i < parts.size(); ++i)
    expect_root("unit", exact_surd(unit[i], "truth.unit[" + std::to_string(i) + "]"), parts[i], length);
  expect_kind_of_root(claim, is_square(length)), claim.facts({});
}

void check_point_plane(const Claim& claim) {
  claim.inputs({"plane", "point"});
  const Plane surface = plane(claim.input["plane"], "plane");
  const Triple p = point_in_space(claim.input["point"], "point");
  claim.answers({"side", "signed_distance"});
  claim.facts({});
  const Rational height = surface.at(p), length = dot(surface.normal, surface.normal);
  expect(claim.word("side") == (sgn(height) < 0 ? "back" : sgn(height) > 0 ? "front" : "on"), "truth: side is wrong");
  const Surd distance = exact_surd(claim.truth["signed_distance"], "truth.signed_distance");
  expect_root("signed_distance", distance, height, length);
  expect_kind_of_root(claim, sgn(height) == 0 || is_square(length));
}

void check_point_plane_toi(const Claim& claim) {
  claim.inputs({"plane", "start", "end"});
  const Plane surface = plane(claim.input["plane"], "plane");
  const Triple start = point_in_space(claim.input["start"], "start"), end = point_in_space(claim.input["end"], "end");
  claim.answers({"option_1", "option_2"});
  claim.expect_kind("heights"), claim.facts({"heights"});
  const Pair heights = claim.pair("heights");
  expect(heights == Pair{surface.at(start), surface.at(end)}, "certificate: the heights are wrong");
  const auto relation = [&claim](const char* option) {
    const json& answer = claim.truth[option];
    const std::string what = std::string("truth.") + option;
    if (answer.is_object() && answer.contains("t")) {
      only(answer, what, {"relation", "t", "point"});
    } else {
      only(answer, what, {"relation"});
    }
    expect(answer["relation"] == "hit" || answer["relation"] == "never", what + ": relation is wrong");
    return answer["relation"] == "hit";
  };
  expect(relation("option_1") == (sgn(heights.y) <= 0) && !claim.truth["option_1"].contains("t"),
         "truth: option_1 is wrong");
  const bool hit = sgn(heights.x) <= 0 || sgn(heights.y) <= 0;
  const json& second = claim.truth["option_2"];
  expect(relation("option_2") == hit && second.contains("t") == hit, "truth: option_2 is wrong");
  if (!hit) return;
  // E is linear along the step: it falls from above 0 to 0 or below, so that before its one zero it is above.
  const Rational t = exact_value(second["t"], "truth.option_2.t");
  const bool first = sgn(heights.x) <= 0
                         ? sgn(t) == 0
                         : sgn(t) > 0 && t <= 1 && sgn(Rational(heights.x + t * (heights.y - heights.x))) == 0;
  expect(first, "truth: t is wrong");
  expect(exact_triple(second["point"], "truth.option_2.point") == along(start, t, end - start),
         "truth: point is not at t");
}

}  // namespace

Checks checks_of_planes() {
  return {{"point_ground_plane", check_point_ground_plane},
          {"polygon_normal", check_polygon_normal},
          {"point_plane", check_point_plane},
          {"point_plane_toi", check_point_plane_toi}};
}

}  // namespace touchstone::certify
