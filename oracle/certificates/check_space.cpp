// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_space.h"

#include <cstdint>

namespace touchstone::certify {
namespace {

void array_of_three(const json& value, const std::string& what) {
  expect(value.is_array() && value.size() == 3, what + ": a list of three");
}

using Coordinates = std::vector<Rational>;

Coordinates three(const json& value, const std::string& what) {
  array_of_three(value, what);
  return two_or_three(value, what);
}

Box box_of(const json& value, const std::string& what, Coordinates (*corner)(const json&, const std::string&)) {
  only(value, what, {"min", "max"});
  const Box result{corner(value["min"], what + ".min"), corner(value["max"], what + ".max")};
  expect(result.max.size() == result.axes(), what + ".max: as many coordinates as min");
  for (std::size_t k = 0; k < result.axes(); ++k)
    expect(result.min[k] <= result.max[k], what + ".max[" + std::to_string(k) + "]: min <= max");
  return result;
}

}  // namespace

bool Box::holds(const std::vector<Rational>& p) const {
  for (std::size_t k = 0; k < axes(); ++k)
    if (p[k] < min[k] || p[k] > max[k]) return false;
  return true;
}

Coordinates two_or_three(const json& value, const std::string& what) {
  expect(value.is_array() && (value.size() == 2 || value.size() == 3), what + ": a list of two or three");
  Coordinates coordinates;
  for (const json& coordinate : value)
    coordinates.push_back(number(coordinate, what + "[" + std::to_string(coordinates.size()) + "]"));
  return coordinates;
}

Triple point_in_space(const json& value, const std::string& what) {
  array_of_three(value, what);
  return {number(value[0], what + "[0]"), number(value[1], what + "[1]"), number(value[2], what + "[2]")};
}

Plane plane(const json& value, const std::string& what) {
  only(value, what, {"normal", "offset"});
  const Plane result{point_in_space(value["normal"], what + ".normal"), number(value["offset"], what + ".offset")};
  expect(!(result.normal == Triple{0, 0, 0}), what + ".normal: nonzero normal");
  return result;
}

std::vector<Triple> points_in_space(const json& value, const std::string& what) {
  expect(value.is_array() && !value.empty(), what + ": at least 1 point");
  std::vector<Triple> points;
  for (const json& point : value)
    points.push_back(point_in_space(point, what + "[" + std::to_string(points.size()) + "]"));
  return points;
}

std::vector<Triple> polygon_in_space(const json& value, const std::string& what) {
  expect(value.is_array(), what + ": a list of vertices");
  std::vector<Triple> vertices;
  for (const json& vertex : value) vertices.push_back(point_in_space(vertex, numbered(what, vertices.size())));
  return open_ring(std::move(vertices), what);
}

Ball ball(const json& value, const std::string& what) {
  only(value, what, {"center", "radius"});
  const Ball result{point_in_space(value["center"], what + ".center"), number(value["radius"], what + ".radius")};
  expect(sgn(result.radius) >= 0, what + ".radius: radius >= 0");
  return result;
}

BallOrDisc ball_or_disc(const json& value, const std::string& what) {
  only(value, what, {"center", "radius"});
  const BallOrDisc result{two_or_three(value["center"], what + ".center"), number(value["radius"], what + ".radius")};
  expect(sgn(result.radius) >= 0, what + ".radius: radius >= 0");
  return result;
}

Box box(const json& value, const std::string& what) { return box_of(value, what, two_or_three); }
Box box_in_space(const json& value, const std::string& what) { return box_of(value, what, three); }

Triple exact_triple(const json& value, const std::string& what) {
  array_of_three(value, what);
  return {exact_value(value[0], what + "[0]"), exact_value(value[1], what + "[1]"),
          exact_value(value[2], what + "[2]")};
}

Triple triple(const Claim& claim, const char* name) {
  return exact_triple(claim.certificate[name], std::string("certificate.") + name);
}

std::vector<Triple> named(const Claim& claim, const char* fact, const std::vector<Triple>& points) {
  std::vector<Triple> found;
  for (const Rational& place : claim.list(fact)) {
    const bool whole = place.get_den() == 1 && sgn(place) >= 0 && place < static_cast<std::uint64_t>(points.size());
    expect(whole, std::string("certificate.") + fact + ": places of points");
    found.push_back(points[place.get_num().get_ui()]);
  }
  return found;
}

void expect_inside(const Box& box, const std::vector<Rational>& p) {
  for (std::size_t k = 0; k < box.axes(); ++k)
    expect(box.min[k] < p[k] && p[k] < box.max[k], "certificate: the point is not inside the box");
}

void expect_flat_axis(const Claim& claim, const Box& box) {
  const Rational axis = claim.single("axis");
  bool found = false;
  for (std::size_t k = 0; k < box.axes(); ++k)
    found = found || (axis == static_cast<std::uint64_t>(k) && box.min[k] == box.max[k]);
  expect(found, "certificate: the box is not flat on the axis");
}

}  // namespace touchstone::certify
