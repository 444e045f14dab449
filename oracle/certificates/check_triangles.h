// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "oracle/certificates/check_space.h"

/// Segments, capsules and triangles of space, in the form of claims, and their checks.
namespace touchstone::certify {

/// Two points are the ends of a segment, three the corners of a triangle, representing their hull.
template <std::size_t count>
std::array<Triple, count> points(const json& value, const std::string& what) {
  expect(value.is_array() && value.size() == count, what + ": a list of " + (count == 2 ? "two" : "three"));
  std::array<Triple, count> found;
  for (std::size_t i = 0; i < count; ++i) found[i] = point_in_space(value[i], what + "[" + std::to_string(i) + "]");
  return found;
}
using Ends3 = std::array<Triple, 2>;
using Corners = std::array<Triple, 3>;

/// All points no farther than the radius, which is not negative, from the segment.
struct Capsule {
  Ends3 segment;
  Rational radius;
};
Capsule capsule_in_space(const json& value, const std::string& what);

/// The point with these weights, which begin at index `from`.
Triple weighted(const std::vector<Triple>& points, const std::vector<Rational>& weights, std::size_t from);
inline Triple weighted(const Corners& corners, const std::vector<Rational>& weights, std::size_t from) {
  return weighted(std::vector<Triple>(corners.begin(), corners.end()), weights, from);
}

/// Requires a plane with no part of the triangle in front of it, `end` in front and x not behind: so is everything from
/// the end to x, except x itself.
void expect_nothing_before(const std::vector<Rational>& plane, const Corners& corners, const Triple& end,
                           const Triple& x);

}  // namespace touchstone::certify
