// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/round_solid.h"

#include <algorithm>
#include <utility>

namespace touchstone::oracle {
namespace {

using Facts = std::vector<std::pair<std::string, std::vector<Rational>>>;

Facts facts_of(const RoundSolid& a, const RoundSolid& b, const NearestPair& nearest) {
  Facts facts;
  const bool both = a.core.size() > 1 && b.core.size() > 1;
  const auto add = [&](const RoundSolid& solid, const char* name, const std::vector<Rational>& weights,
                       const Point3<Rational>& p) {
    if (solid.core.size() == 1) return;
    if (solid.width) return facts.push_back({name, {p.x, p.y, p.z}});
    facts.push_back({both        ? name
                     : solid.box ? "coefficients"
                                 : "weights",
                     solid.box ? coefficients_of(weights) : weights});
  };
  add(a, "on_a", nearest.weights_of_a, nearest.on_a), add(b, "on_b", nearest.weights_of_b, nearest.on_b);
  return facts;
}

}  // namespace

std::vector<Rational> coefficients_of(const std::vector<Rational>& weights) {
  std::vector<Rational> sums(3);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) sums[k] += (i >> k & 1U) != 0 ? weights[i] : Rational(-weights[i]);
  return sums;
}

Hull corners_of(const Obb3<Rational>& box) {
  const auto& [u, v, w] = box.half_axes;
  Hull corners;
  for (unsigned i = 0; i < 8; ++i) {
    const auto sign = [i](unsigned k) { return Rational((i >> k & 1U) != 0 ? 1 : -1); };
    corners.push_back(box.center + (sign(0) * u + (sign(1) * v + sign(2) * w)));
  }
  return corners;
}

Truth<Contact> contact_of(const RoundSolid& a, const RoundSolid& b) {
  const bool many = a.core.size() + b.core.size() > 4;
  return contact_of(a, b, many ? any_nearest_pair(a.core, b.core) : nearest_pair(a.core, b.core));
}

Truth<Contact> contact_of(const RoundSolid& a, const RoundSolid& b, const NearestPair& nearest) {
  std::vector<Rational> radii = a.radii;
  radii.insert(radii.end(), b.radii.begin(), b.radii.end());
  Rational sum;
  for (const Rational& radius : radii) sum += radius;
  const Rational reach(sum * sum), depth(reach - nearest.squared_distance);
  Rational margin = abs(depth);
  if (sgn(depth) >= 0) {
    for (const Rational& radius : radii) {
      const Rational others(sum - radius);
      margin = std::min(margin, Rational(reach - others * others));
    }
    for (const RoundSolid* solid : {&a, &b})
      if (solid->width) margin = std::min(margin, Rational(*solid->width * *solid->width));
  }
  const Contact contact = sgn(depth) < 0    ? Contact::disjoint
                          : sgn(margin) > 0 ? Contact::overlapping
                                            : Contact::touching;
  const char* kind = contact == Contact::disjoint      ? "nearest_points"
                     : contact == Contact::overlapping ? "near_points"
                     : sgn(depth) == 0                 ? "tangent"
                                                       : "no_interior";
  return {contact, margin, [kind, facts = facts_of(a, b, nearest)]() -> Certificate { return {kind, facts}; }};
}

}  // namespace touchstone::oracle
