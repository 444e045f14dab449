// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/certificates/check_rings.h"
#include "oracle/certificates/check_space.h"

/// Convex hulls. The truth gives indices in the list of points; the certificate repeats those that are extreme, so that
/// of equal points only the one in the truth is claimed.
namespace touchstone::certify {
namespace {

using Places = std::vector<std::size_t>;

std::size_t place_in_input(const json& value, const std::string& what, std::size_t count) {
  expect(value.is_number_unsigned() && value.get<std::uint64_t>() < count, what + ": not an index");
  return value.get<std::size_t>();
}

/// A list of at least `fewest` indices in the truth.
Places places(const json& list, const std::string& what, std::size_t fewest, std::size_t count) {
  expect(list.is_array() && list.size() >= fewest, what + ": a list of at least " + std::to_string(fewest));
  Places found;
  for (const json& value : list) found.push_back(place_in_input(value, what, count));
  return found;
}

std::size_t dimension(const Claim& claim) {
  const bool there = claim.truth.is_object() && claim.truth.contains("dimension");
  expect(there && claim.truth["dimension"].is_number_unsigned(), "truth: field dimension is missing");
  return claim.truth["dimension"].get<std::size_t>();
}

/// The corners of the truth if it is not a solid.
Places corners(const Claim& claim, std::size_t count) {
  if (dimension(claim) == 0) {
    claim.answers({"dimension", "point"});
    return {place_in_input(claim.truth["point"], "truth.point", count)};
  }
  if (dimension(claim) == 1) {
    claim.answers({"dimension", "segment"});
    const Places ends = places(claim.truth["segment"], "truth.segment", 2, count);
    expect(ends.size() == 2, "truth.segment: a list of two");
    return ends;
  }
  expect(dimension(claim) == 2, "truth: dimension is wrong");
  claim.answers({"dimension", "polygon"});
  return places(claim.truth["polygon"], "truth.polygon", 3, count);
}

/// Requires that the distinct corners are the indices in `extreme`, in any order.
void expect_extreme(const Claim& claim, Places used) {
  std::vector<Rational> listed = claim.list("extreme");
  std::sort(listed.begin(), listed.end());
  std::sort(used.begin(), used.end());
  const bool same = std::equal(listed.begin(), listed.end(), used.begin(), used.end(),
                               [](const Rational& n, std::size_t i) { return n == static_cast<std::uint64_t>(i); });
  expect(same, "certificate: extreme are other points than in the truth");
}

void expect_extreme_points(const Claim& claim, const char* kind) {
  claim.expect_kind(kind);
  claim.facts({"extreme"});
}

template <class Point>
void expect_all_equal(const std::vector<Point>& points) {
  for (const Point& p : points) expect(p == points[0], "truth: the points are not all equal");
}

/// True if p is on the segment from a to b, which are different points.
bool between(const Pair& a, const Pair& p, const Pair& b) {
  return sgn(cross(b - a, p - a)) == 0 && sgn(dot(p - a, p - b)) <= 0;
}
bool between(const Triple& a, const Triple& p, const Triple& b) {
  return cross(b - a, p - a) == Triple{0, 0, 0} && sgn(dot(p - a, p - b)) <= 0;
}

template <class Point>
void expect_segment(const std::vector<Point>& points, const Places& ends) {
  const Point &a = points[ends[0]], &b = points[ends[1]];
  expect(!(a == b), "truth: the ends are one point");
  for (const Point& p : points) expect(between(a, p, b), "truth: a point is outside");
}

/// Requires that every corner turns left and every point is on the left of every edge or on it. So each corner is the
/// tip of a wedge that contains all points, hence extreme, and each edge ends at the next extreme point; as no corner
/// repeats, the ring makes one turn.
void expect_polygon(const std::vector<Pair>& points, const Places& ring) {
  const auto corner = [&](std::size_t i) { return points[ring[i % ring.size()]]; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Ends e{corner(i), corner(i + 1)};
    expect(side(e, corner(i + 2)) > 0, "truth: no turn to the left at a corner");
    for (const Pair& p : points) expect(side(e, p) >= 0, "truth: a point is outside");
    for (std::size_t k = 0; k < i; ++k) expect(!(corner(k) == corner(i)), "truth: a corner twice");
  }
}

/// The same about the normal of the plane, which contains all points.
void expect_polygon(const std::vector<Triple>& points, const Places& ring) {
  const auto corner = [&](std::size_t i) { return points[ring[i % ring.size()]]; };
  const Triple normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Triple a = corner(i), e = corner(i + 1) - a;
    expect(sgn(dot(normal, cross(e, corner(i + 2) - a))) > 0, "truth: no turn to the left at a corner");
    for (const Triple& p : points) {
      expect(sgn(dot(normal, p - a)) == 0, "truth: a point is off the plane");
      expect(sgn(dot(normal, cross(e, p - a))) >= 0, "truth: a point is outside");
    }
    for (std::size_t k = 0; k < i; ++k) expect(!(corner(k) == a), "truth: a corner twice");
  }
}

using FacePlaces = std::array<std::size_t, 3>;

std::vector<FacePlaces> faces(const json& list, std::size_t count) {
  expect(list.is_array() && list.size() >= 4, "truth.faces: a list of at least 4");
  std::vector<FacePlaces> found;
  for (const json& value : list) {
    const Places named = places(value, "truth.faces", 3, count);
    expect(named.size() == 3, "truth.faces: three places each");
    found.push_back({named[0], named[1], named[2]});
  }
  return found;
}

/// True if three of these normals span space, so that their planes have one point in common.
bool span_space(const std::vector<Triple>& normals) {
  Triple line{0, 0, 0};
  for (const Triple& n : normals) {
    if (sgn(dot(line, n)) != 0) return true;
    if (line == Triple{0, 0, 0}) line = cross(normals[0], n);
  }
  return false;
}

/// Triangles that have an area, with all points below their planes or in them, and some below, lie on the boundary of
/// the hull and face outwards. With every edge once in each direction they have no rim: they cover the entire boundary,
/// every part of it equally often. A corner whose faces' normals span space is extreme. Corners that are extreme and
/// different
/// points leave for an edge of the hull nothing but the one edge between its ends, which is there once: so they cover
/// the boundary once, and as an extreme point is inside no triangle and no edge, all of them are corners.
Places expect_faces(const std::vector<Triple>& points, const std::vector<FacePlaces>& triangles) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  std::map<std::size_t, std::vector<Triple>> normals;
  for (const FacePlaces& t : triangles) {
    const Triple normal = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    expect(!(normal == Triple{0, 0, 0}), "truth: a face has no area");
    for (std::size_t k = 0; k < 3; ++k) {
      expect(edges.insert({t[k], t[(k + 1) % 3]}).second, "truth: an edge twice in one direction");
      normals[t[k]].push_back(normal);
    }
    bool below = false;
    for (const Triple& p : points) {
      const int side = sgn(dot(normal, p - points[t[0]]));
      expect(side <= 0, "truth: a point is outside");
      below = below || side < 0;
    }
    expect(below, "truth: all points are in one plane");
  }
  for (const auto& [from, to] : edges) expect(edges.count({to, from}) == 1, "truth: an edge in one direction only");
  Places corners;
  for (const auto& [corner, around] : normals) {
    expect(span_space(around), "truth: a corner is not extreme");
    for (const std::size_t other : corners) expect(!(points[other] == points[corner]), "truth: a corner twice");
    corners.push_back(corner);
  }
  return corners;
}

template <class Point>
std::vector<Point> listed_points(const Claim& claim, Point (*read)(const json&, const std::string&)) {
  claim.inputs({"points"});
  const json& list = claim.input["points"];
  expect(list.is_array(), "points: a list");
  expect(!list.empty(), "points: at least 1 point");
  std::vector<Point> points;
  for (const json& p : list) points.push_back(read(p, "points[" + std::to_string(points.size()) + "]"));
  return points;
}

template <class Point>
void check_flat(const Claim& claim, const std::vector<Point>& points) {
  const Places ring = corners(claim, points.size());
  expect_extreme_points(claim, ring.size() == 1 ? "one_point" : ring.size() == 2 ? "segment" : "polygon");
  if (ring.size() == 1) expect_all_equal(points);
  else if (ring.size() == 2) expect_segment(points, ring);
  else expect_polygon(points, ring);
  expect_extreme(claim, ring);
}

void check_convex_hull_2d(const Claim& claim) { check_flat(claim, listed_points<Pair>(claim, point)); }

void check_convex_hull(const Claim& claim) {
  const std::vector<Triple> points = listed_points<Triple>(claim, point_in_space);
  if (dimension(claim) == 3) {
    claim.answers({"dimension", "faces"});
    const std::vector<FacePlaces> triangles = faces(claim.truth["faces"], points.size());
    expect_extreme_points(claim, "faces");
    expect_extreme(claim, expect_faces(points, triangles));
  } else {
    check_flat(claim, points);
  }
}

}  // namespace

Checks checks_of_hulls() { return {{"convex_hull_2d", check_convex_hull_2d}, {"convex_hull", check_convex_hull}}; }

}  // namespace touchstone::certify
