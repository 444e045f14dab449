// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_obbs.h"

#include <algorithm>
#include <string>

#include "oracle/certificates/check_triangles.h"

namespace touchstone::certify {
namespace {

/// The coefficients of a point are unique, because the half axes are independent.
void check_point_in_obb(const Claim& claim) {
  claim.inputs({"obb", "point"});
  const Obb box = obb(claim.input["obb"], "obb");
  const Triple p = point_in_space(claim.input["point"], "point");
  claim.answers({"location"});
  const std::string location = claim.word("location");
  if (location == "outside") {
    claim.expect_kind("separating_plane"), claim.facts({"normal"});
    const Triple normal = triple(claim, "normal");
    expect(dot(normal, p - box.center) > box.reach(normal), "certificate: the plane does not separate");
    return;
  }
  claim.expect_kind("coefficients"), claim.facts({"coefficients"});
  const std::vector<Rational> coefficients = claim.list("coefficients");
  const Rational growth = greatest(coefficients, "coefficients");
  expect(box.at(coefficients) == p, "certificate: the coefficients give another point");
  expect(growth <= 1, "certificate: the point is not in the box");
  expect(location == (growth < 1 ? "inside" : "boundary"), "truth: location is wrong");
}

/// The contact of a solid and a box, `whole` naming both: gap(normal) is how far the box is beyond the other along a
/// normal; growth() requires a common point, and is less than 1 where that is inside, 1 at most where it is in both.
template <class Gap, class Growth>
void check_along_normal(const Claim& claim, const std::string& whole, const Gap& gap, const Growth& growth) {
  claim.answers({"contact"});
  const std::string contact = claim.word("contact");
  if (contact == "disjoint") {
    claim.expect_kind("separating_axis"), claim.facts({"normal"});
    expect(sgn(gap(triple(claim, "normal"))) > 0, "certificate: the axis does not separate");
    return;
  }
  const bool touching = contact == "touching";
  expect(touching || contact == "overlapping", "truth: contact is wrong");
  expect(claim.kind() == (touching ? "supporting_axis" : "common_interior_point"), wrong_kind);
  if (touching) claim.facts({"on_a", "on_b", "normal"});
  else claim.facts({"on_a", "on_b"});
  const Rational found = growth();
  if (touching) {
    expect(found <= 1, "certificate: the point is not in " + whole);
    const Triple normal = triple(claim, "normal");
    const bool supports = !(normal == Triple{0, 0, 0}) && sgn(gap(normal)) == 0;
    expect(supports, "certificate: the axis does not support");
  } else {
    expect(found < 1, "certificate: the point is not inside " + whole);
  }
}

void check_obb_obb(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Obb a = obb(claim.input["a"], "a"), b = obb(claim.input["b"], "b");
  const auto gap = [&](const Triple& normal) {
    return Rational(dot(normal, b.center - a.center) - a.reach(normal) - b.reach(normal));
  };
  check_along_normal(claim, "both boxes", gap, [&] {
    const std::vector<Rational> on_a = claim.list("on_a"), on_b = claim.list("on_b");
    const Rational growth = std::max(greatest(on_a, "on_a"), greatest(on_b, "on_b"));
    expect(a.at(on_a) == b.at(on_b), "certificate: the coefficients give two points");
    return growth;
  });
}

void check_triangle_obb(const Claim& claim) {
  claim.inputs({"triangle", "obb"});
  const Corners corners = points<3>(claim.input["triangle"], "triangle");
  const Obb box = obb(claim.input["obb"], "obb");
  const auto gap = [&](const Triple& normal) {
    const auto height = [&normal](const Triple& p) { return Rational(dot(normal, p)); };
    const auto& [a, b, c] = corners;
    return Rational(height(box.center) - box.reach(normal) - std::max({height(a), height(b), height(c)}));
  };
  check_along_normal(claim, "the box", gap, [&] {
    const std::vector<Rational> weights = claim.list("on_a"), coefficients = claim.list("on_b");
    const Rational growth = greatest(coefficients, "on_b");
    expect(weights.size() == 3, "certificate: as many weights as points");
    const bool same = weighted(corners, weights, 0) == box.at(coefficients);
    expect(same, "certificate: the weights and coefficients give two points");
    return growth;
  });
}

void check_aabb_obb(const Claim& claim) {
  claim.inputs({"aabb", "obb"});
  const Box box = box_in_space(claim.input["aabb"], "aabb");
  const Obb other = obb(claim.input["obb"], "obb");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool disjoint = contact == "disjoint", overlapping = contact == "overlapping", flat = kind == "flat_axis";
  expect(disjoint || overlapping || contact == "touching", "truth: contact is wrong");
  expect(disjoint      ? kind == "separating_axis"
         : overlapping ? kind == "common_interior_point"
                       : flat || kind == "supporting_axis",
         wrong_kind);
  const auto gap = [&](const Triple& n) {
    const auto most = [](const Rational& slope, const Rational& min, const Rational& max) {
      return Rational(slope * (sgn(slope) > 0 ? max : min));
    };
    return Rational(dot(n, other.center) - other.reach(n) - most(n.x, box.min[0], box.max[0]) -
                    most(n.y, box.min[1], box.max[1]) - most(n.z, box.min[2], box.max[2]));
  };
  if (disjoint) {
    claim.facts({"normal"});
    expect(sgn(gap(triple(claim, "normal"))) > 0, "certificate: the axis does not separate");
    return;
  }
  if (overlapping) claim.facts({"coefficients"});
  else if (flat) claim.facts({"coefficients", "axis"});
  else claim.facts({"coefficients", "normal"});
  const std::vector<Rational> coefficients = claim.list("coefficients");
  const Rational growth = greatest(coefficients, "coefficients");
  const Triple point = other.at(coefficients);
  const std::vector<Rational> x{point.x, point.y, point.z};
  if (overlapping) {
    expect(growth < 1, "certificate: the point is not inside both boxes");
    expect_inside(box, x);
    return;
  }
  expect(growth <= 1 && box.holds(x), "certificate: the point is not in both boxes");
  if (flat) {
    expect_flat_axis(claim, box);
    return;
  }
  const Triple normal = triple(claim, "normal");
  const bool supports = !(normal == Triple{0, 0, 0}) && sgn(gap(normal)) == 0;
  expect(supports, "certificate: the axis does not support");
}

}  // namespace

Rational greatest(const std::vector<Rational>& coefficients, const std::string& name) {
  expect(coefficients.size() == 3, "certificate." + name + ": a list of three");
  Rational result;
  for (const Rational& each : coefficients) result = std::max<Rational>(result, abs(each));
  return result;
}

Triple Obb::at(const std::vector<Rational>& coefficients) const {
  Triple p = center;
  for (std::size_t k = 0; k < 3; ++k) p = along(p, coefficients[k], half_axes[k]);
  return p;
}

Rational Obb::reach(const Triple& normal) const {
  Rational sum;
  for (const Triple& half_axis : half_axes) sum += abs(dot(normal, half_axis));
  return sum;
}

Obb obb(const json& value, const std::string& what) {
  only(value, what, {"center", "half_axes"});
  Obb result{point_in_space(value["center"], what + ".center"), {}};
  const json& axes = value["half_axes"];
  const std::string name = what + ".half_axes";
  expect(axes.is_array() && axes.size() == 3, name + ": a list of three");
  for (std::size_t k = 0; k < 3; ++k)
    result.half_axes[k] = point_in_space(axes[k], name + "[" + std::to_string(k) + "]");
  const auto& [u, v, w] = result.half_axes;
  const Rational volume(u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x));
  expect(sgn(volume) != 0, name + ": linearly independent");
  return result;
}

Checks checks_of_obbs() {
  return {{"obb_obb", check_obb_obb},
          {"aabb_obb", check_aabb_obb},
          {"triangle_obb", check_triangle_obb},
          {"point_in_obb", check_point_in_obb}};
}

}  // namespace touchstone::certify
