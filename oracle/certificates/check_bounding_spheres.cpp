// SPDX-License-Identifier: Apache-2.0
#include <cstdint>

#include "oracle/certificates/check_space.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

using Points = std::vector<Triple>;

Triple plus(const Triple& p, const Rational& weight, const Triple& q) { return along(p, weight, q); }
Rational squared_distance(const Triple& p, const Triple& q) { return dot(p - q, p - q); }

std::string method_of(const Claim& claim) {
  if (!claim.input.contains("method")) return "smallest";
  const json& method = claim.input["method"];
  const bool known = method == "box" || method == "centroid" || method == "ritter" || method == "smallest";
  expect(known, "method: one of box, centroid, ritter, smallest");
  return method.get<std::string>();
}

Triple middle_of_box(const Points& points) {
  Triple low = points[0], high = points[0];
  for (const Triple& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return along(low, Rational(1, 2), high - low);
}

Triple mean(const Points& points) {
  Triple sum{0, 0, 0};
  for (const Triple& p : points) sum = plus(sum, 1, p);
  return along(Triple{0, 0, 0}, Rational(1, static_cast<std::uint64_t>(points.size())), sum);
}

/// The combination of points with the weights of the certificate, which are not negative and add up to 1.
Triple combined(const std::vector<Rational>& weights, const Points& support) {
  expect(weights.size() == support.size(), "certificate.weights: as many as points");
  Triple center{0, 0, 0};
  Rational sum;
  for (std::size_t i = 0; i < support.size(); ++i) {
    expect(sgn(weights[i]) >= 0, "certificate: a weight is negative");
    sum += weights[i];
    center = plus(center, weights[i], support[i]);
  }
  expect(sum == 1, "certificate: the weights do not add up to 1");
  return center;
}

/// smallest: any other center is farther than the radius from one of the points of which this one is a combination, all
/// of them at that distance. (Their mean squared distance from a center c is that from this one and its squared
/// distance from c.) ritter: by the same, no ball around the points has a squared radius below the mean of their
/// squared distances; one grown as the contract says has at most 3/2 of the least.
void check_bounding_sphere(const Claim& claim) {
  const bool with_method = claim.input.is_object() && claim.input.contains("method");
  if (with_method) claim.inputs({"points", "method"});
  else claim.inputs({"points"});
  const Points points = points_in_space(claim.input["points"], "points");
  const std::string method = method_of(claim);
  claim.answers({"sphere"});
  const json& sphere = claim.truth["sphere"];
  only(sphere, "truth.sphere", {"center", "radius"});
  const Triple center = exact_triple(sphere["center"], "truth.sphere.center");
  const Surd radius = exact_surd(sphere["radius"], "truth.sphere.radius"), squared_radius = square(radius);
  expect(sign(radius) >= 0, "truth: the radius is negative");
  const auto beyond = [&](const Triple& p) { return -sign(squared_radius + Rational(-squared_distance(center, p))); };
  for (const Triple& p : points) expect(beyond(p) <= 0, "truth: a point is outside of the ball");
  const std::string kind = claim.kind();
  const char* const not_reached = "certificate: a point is not on the boundary of the ball";
  if (method == "box" || method == "centroid") {
    expect(kind == "farthest_point", wrong_kind), claim.facts({"point"});
    const Points farthest = named(claim, "point", points);
    expect(farthest.size() == 1, "certificate.point: a list of one");
    expect(center == (method == "box" ? middle_of_box(points) : mean(points)), "truth: the center is wrong");
    expect(beyond(farthest[0]) == 0, not_reached);
    return;
  }
  expect(kind == (method == "smallest" ? "support" : "lower_bound"), wrong_kind), claim.facts({"points", "weights"});
  const Points support = named(claim, "points", points);
  const std::vector<Rational> weights = claim.list("weights");
  const Triple balanced = combined(weights, support);
  if (method == "smallest") {
    expect(balanced == center, "certificate: the weights do not give the center");
    for (const Triple& p : support) expect(beyond(p) == 0, not_reached);
    return;
  }
  Rational bound;
  for (std::size_t i = 0; i < support.size(); ++i) bound += weights[i] * squared_distance(balanced, support[i]);
  expect(sign(squared_radius + Rational(-9 * bound / 4)) <= 0, "truth: the radius is more than 3/2 of the least");
}

}  // namespace

Checks checks_of_bounding_spheres() { return {{"bounding_sphere", check_bounding_sphere}}; }

}  // namespace touchstone::certify
