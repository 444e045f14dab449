// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "oracle/certificates/check_space.h"

/// Volumes of intervals around points: boxes and k-DOPs.
namespace touchstone::certify {
namespace {

using Numbers = std::vector<Rational>;

const char* const wrong_value = "certificate: the value of N . P is wrong";

/// A list of points of one dimension, two or three; at least one.
std::vector<Numbers> points_of_any_axes(const json& value, const std::string& what) {
  expect(value.is_array() && !value.empty(), what + ": at least 1 point");
  std::vector<Numbers> found;
  for (const json& written : value) {
    const std::string each = what + "[" + std::to_string(found.size()) + "]";
    expect(written.is_array() && (written.size() == 2 || written.size() == 3), each + ": a list of two or three");
    Numbers point;
    for (const json& coordinate : written) {
      point.push_back(number(coordinate, each + "[" + std::to_string(point.size()) + "]"));
    }
    expect(found.empty() || found.front().size() == point.size(), each + ": as many coordinates as the first");
    found.push_back(std::move(point));
  }
  return found;
}

/// A fact that gives an index in a list.
std::size_t place(const Rational& index, std::size_t size, const char* of_what) {
  expect(index.get_den() == 1 && sgn(index) >= 0 && index < Rational(mpz_class(size)),
         std::string("certificate: no ") + of_what + " has this place");
  return index.get_num().get_ui();
}

Numbers exact_values(const json& value, const std::string& what, std::size_t size) {
  expect(value.is_array() && value.size() == size, what + ": a list of " + (size == 2 ? "two" : "three"));
  Numbers found;
  for (const json& each : value) found.push_back(exact_value(each, what + "[" + std::to_string(found.size()) + "]"));
  return found;
}

/// Requires that a point of the list has the end on each axis, and that no point is beyond.
void check_aabb_of_points(const Claim& claim) {
  claim.inputs({"points"});
  const std::vector<Numbers> all = points_of_any_axes(claim.input["points"], "points");
  const std::size_t axes = all[0].size();
  claim.answers({"aabb"});
  only(claim.truth["aabb"], "truth.aabb", {"min", "max"});
  const Numbers low = exact_values(claim.truth["aabb"]["min"], "truth.aabb.min", axes),
                high = exact_values(claim.truth["aabb"]["max"], "truth.aabb.max", axes);
  claim.expect_kind("extreme_points");
  claim.facts({"least", "greatest"});
  const Numbers least = claim.list("least"), greatest = claim.list("greatest");
  expect(least.size() == axes && greatest.size() == axes, "certificate: two places for each axis");
  for (std::size_t k = 0; k < axes; ++k) {
    expect(all[place(least[k], all.size(), "point")][k] == low[k] &&
               all[place(greatest[k], all.size(), "point")][k] == high[k],
           "certificate: the point has another coordinate");
    for (const Numbers& p : all) expect(low[k] <= p[k] && p[k] <= high[k], "truth: a point is not in the box");
  }
}

/// Normals and the ends of their slabs, x <= y.
struct Kdop {
  std::vector<Triple> normals;
  std::vector<Pair> slabs;
  bool holds(std::size_t i, const Rational& value) const { return slabs[i].x <= value && value <= slabs[i].y; }
};

Triple normal(const json& value, const std::string& what) {
  const Triple n = point_in_space(value, what);
  expect(n.x != 0 || n.y != 0 || n.z != 0, what + ": nonzero normal");
  return n;
}

Kdop kdop(const json& value, const std::string& what) {
  only(value, what, {"normals", "slabs"});
  const json &normals = value["normals"], &slabs = value["slabs"];
  expect(normals.is_array() && !normals.empty(), what + ".normals: at least 1 normal");
  expect(slabs.is_array() && slabs.size() == normals.size(), what + ".slabs: as many slabs as normals");
  Kdop found;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]", slab = what + ".slabs" + at;
    found.normals.push_back(normal(normals[i], what + ".normals" + at));
    found.slabs.push_back(point(slabs[i], slab));
    expect(found.slabs[i].x <= found.slabs[i].y, slab + "[1]: min <= max");
  }
  return found;
}

/// Outside: beyond an end of one slab. On the boundary: at an end of one, and within all. Inside: strictly within all.
void check_point_in_kdop(const Claim& claim) {
  claim.inputs({"kdop", "point"});
  const Kdop solid = kdop(claim.input["kdop"], "kdop");
  const Triple p = point_in_space(claim.input["point"], "point");
  claim.answers({"location"});
  const std::string location = claim.word("location"), kind = claim.kind();
  Numbers values;
  for (const Triple& n : solid.normals) values.push_back(dot(n, p));
  if (location == "inside") {
    expect(kind == "values", wrong_kind), claim.facts({"values"});
    expect(claim.list("values") == values, wrong_value);
    for (std::size_t i = 0; i < values.size(); ++i)
      expect(solid.slabs[i].x < values[i] && values[i] < solid.slabs[i].y, "truth: the point is not inside a slab");
    return;
  }
  expect(location == "boundary" || location == "outside", "truth: location is wrong");
  const bool outside = location == "outside";
  expect(kind == (outside ? "beyond_slab" : "end_of_slab"), wrong_kind), claim.facts({"slab", "value"});
  const std::size_t i = place(claim.single("slab"), values.size(), "slab");
  expect(claim.single("value") == values[i], wrong_value);
  if (outside) {
    expect(!solid.holds(i, values[i]), "certificate: the slab holds the point");
    return;
  }
  expect(values[i] == solid.slabs[i].x || values[i] == solid.slabs[i].y, "certificate: the slab does not end there");
  for (std::size_t k = 0; k < values.size(); ++k) expect(solid.holds(k, values[k]), "truth: a slab excludes the point");
}

/// Slab by slab. Disjoint: a value between two slabs. Overlapping: a value strictly within each two. Touching: a value
/// within each two, and two that have no interval in common.
void check_kdop_kdop(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Kdop a = kdop(claim.input["a"], "a"), b = kdop(claim.input["b"], "b");
  const std::size_t count = a.normals.size();
  expect(b.normals.size() == count, "b.normals: the same normals as a");
  for (std::size_t i = 0; i < count; ++i)
    expect(a.normals[i] == b.normals[i], "b.normals[" + std::to_string(i) + "]: the same normal as in a");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  if (contact == "disjoint") {
    expect(kind == "separating_slab", wrong_kind), claim.facts({"slab", "value"});
    const std::size_t i = place(claim.single("slab"), count, "slab");
    const Rational value = claim.single("value");
    expect((a.slabs[i].y < value && value < b.slabs[i].x) || (b.slabs[i].y < value && value < a.slabs[i].x),
           "certificate: the slabs are not apart there");
    return;
  }
  const bool touching = contact == "touching";
  expect(touching || contact == "overlapping", "truth: contact is wrong");
  expect(kind == (touching ? "touching_slab" : "common_values"), wrong_kind);
  touching ? claim.facts({"slab", "values"}) : claim.facts({"values"});
  const Numbers values = claim.list("values");
  expect(values.size() == count, "certificate: a value for each normal");
  for (std::size_t i = 0; i < count; ++i) {
    const Pair &s = a.slabs[i], &t = b.slabs[i];
    const bool held = a.holds(i, values[i]) && b.holds(i, values[i]);
    expect(
        touching ? held : s.x < values[i] && values[i] < s.y && t.x < values[i] && values[i] < t.y,
        touching ? "certificate: a slab does not hold the value" : "certificate: the value is not inside both slabs");
  }
  if (!touching) return;
  const std::size_t i = place(claim.single("slab"), count, "slab");
  const Pair &s = a.slabs[i], &t = b.slabs[i];
  expect(s.x == s.y || t.x == t.y || s.y == t.x || t.y == s.x, "certificate: these slabs have an interval in common");
}

/// Requires for each normal that points of the list have the ends as their N . P, and that no point is beyond.
void check_kdop_of_points(const Claim& claim) {
  claim.inputs({"points", "normals"});
  const json& written = claim.input["normals"];
  const std::vector<Triple> all = points_in_space(claim.input["points"], "points");
  expect(written.is_array() && !written.empty(), "normals: at least 1 normal");
  std::vector<Triple> normals;
  for (const json& one : written) normals.push_back(normal(one, "normals[" + std::to_string(normals.size()) + "]"));
  claim.answers({"slabs"});
  const json& slabs = claim.truth["slabs"];
  expect(slabs.is_array() && slabs.size() == normals.size(), "truth.slabs: as many slabs as normals");
  claim.expect_kind("extreme_points"), claim.facts({"least", "greatest"});
  const Numbers least = claim.list("least"), greatest = claim.list("greatest");
  expect(least.size() == normals.size() && greatest.size() == normals.size(),
         "certificate: two places for each normal");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Pair slab = exact_pair(slabs[i], "truth.slabs[" + std::to_string(i) + "]");
    expect(dot(normals[i], all[place(least[i], all.size(), "point")]) == slab.x &&
               dot(normals[i], all[place(greatest[i], all.size(), "point")]) == slab.y,
           "certificate: the slab does not end at this point");
    for (const Triple& p : all) {
      const Rational value = dot(normals[i], p);
      expect(slab.x <= value && value <= slab.y, "truth: a point is not in the slab");
    }
  }
}

}  // namespace

Checks checks_of_kdops() {
  return {{"aabb_of_points", check_aabb_of_points},
          {"kdop_of_points", check_kdop_of_points},
          {"point_in_kdop", check_point_in_kdop},
          {"kdop_kdop", check_kdop_kdop}};
}

}  // namespace touchstone::certify
