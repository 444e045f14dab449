// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

using Points = std::vector<Triple>;

/// The points of a fact, which must be this many.
Points named(const Claim& claim, const char* fact, const Points& points, std::size_t count) {
  Points found = certify::named(claim, fact, points);
  expect(found.size() == count, std::string("certificate.") + fact + ": a place for each half axis that is not 0");
  return found;
}

/// Along perpendicular half axes a point has one coefficient each, and the rest of its displacement from the center, if
/// some are 0, must be zero.
void check_obb_of_points(const Claim& claim) {
  claim.inputs({"points"});
  const Points points = points_in_space(claim.input["points"], "points");
  claim.answers({"obb"});
  const json& obb = claim.truth["obb"];
  only(obb, "truth.obb", {"center", "half_axes"});
  const Triple center = exact_triple(obb["center"], "truth.obb.center");
  const json& written = obb["half_axes"];
  expect(written.is_array() && written.size() == 3, "truth.obb.half_axes: a list of three");
  std::array<Triple, 3> half_axes;
  for (std::size_t k = 0; k < 3; ++k)
    half_axes[k] = exact_triple(written[k], "truth.obb.half_axes[" + std::to_string(k) + "]");
  for (std::size_t k = 0; k < 3; ++k)
    expect(sgn(dot(half_axes[k], half_axes[(k + 1) % 3])) == 0, "truth: the half axes are not at right angles");
  claim.expect_kind("touched_faces"), claim.facts({"least", "most"});
  const Triple nothing{0, 0, 0};
  std::vector<Triple> proper;
  for (const Triple& a : half_axes)
    if (!(a == nothing)) proper.push_back(a);
  const Points least = named(claim, "least", points, proper.size()), most = named(claim, "most", points, proper.size());
  const auto coefficient = [&](const Triple& p, const Triple& a) { return Rational(dot(p - center, a) / dot(a, a)); };
  for (const Triple& p : points) {
    Triple left = p - center;
    for (const Triple& a : proper) {
      const Rational t = coefficient(p, a);
      expect(abs(t) <= 1, "truth: a point is outside of the box");
      left = along(left, Rational(-t), a);
    }
    expect(left == nothing, "truth: a point is outside of the box");
  }
  for (std::size_t k = 0; k < proper.size(); ++k) {
    const bool touched = coefficient(least[k], proper[k]) == -1 && coefficient(most[k], proper[k]) == 1;
    expect(touched, "certificate: a point is not on the face");
  }
}

}  // namespace

Checks checks_of_bounding_obbs() { return {{"obb_of_points", check_obb_of_points}}; }

}  // namespace touchstone::certify
