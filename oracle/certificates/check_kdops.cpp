// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "oracle/certificates/check_space.h"

/// Volumes of intervals around points: boxes and k-DOPs.
namespace touchstone::certify {
namespace {

using Numbers = std::vector<Rational>;

/// A list of points of one dimension, two or three; at least one.
std::vector<Numbers> points(const json& value, const std::string& what) {
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

/// A fact that names a place in a list.
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

/// A point of the list has the end on each axis, and no point is beyond.
void check_aabb_of_points(const Claim& claim) {
  claim.inputs({"points"});
  const std::vector<Numbers> all = points(claim.input["points"], "points");
  const std::size_t axes = all[0].size();
  claim.answers({"aabb"});
  only(claim.truth["aabb"], "truth.aabb", {"min", "max"});
  const Numbers low = exact_values(claim.truth["aabb"]["min"], "truth.aabb.min", axes),
                high = exact_values(claim.truth["aabb"]["max"], "truth.aabb.max", axes);
  expect(claim.kind() == "extreme_points", "certificate: no such kind for this truth");
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

}  // namespace

Checks checks_of_kdops() { return {{"aabb_of_points", check_aabb_of_points}}; }

}  // namespace touchstone::certify
