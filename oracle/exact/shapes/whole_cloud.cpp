// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/shapes/whole_cloud.h"

#include <algorithm>
#include <set>
#include <utility>

#include "oracle/exact/shapes/extreme_ring.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {
namespace {

template <class Number>
std::vector<Number> numbers_of(const std::vector<Point3<Number>>& points) {
  std::vector<Number> numbers;
  for (const auto& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return numbers;
}

/// Compares vectors in one direction.
bool longer(const Vector3<Integer>& v, const Vector3<Integer>& w) {
  return abs(v.x) + abs(v.y) + abs(v.z) > abs(w.x) + abs(w.y) + abs(w.z);
}

/// Rotates a plane, behind which all points lie, about an edge of the hull until it contains a face: as seen along the
/// edge, the points off `known` lie within less than half a turn. From outside that face has the edge from a to b.
SupportingPlane folded(const IntegerCloud& cloud, const SupportingPlane& known, Index a, Index b) {
  SupportingPlane plane{{0, 0, 0}, 0};
  for (Index p = 0; p < cloud.size(); ++p) {
    if (!zero(plane.normal) && sgn(cloud.height(plane, p)) <= 0) continue;
    if (sgn(cloud.height(known, p)) != 0) plane = cloud.plane(cloud.normal(a, b, p), a);
  }
  return plane;
}

/// Twice the area of three points in a plane as seen along an axis that the plane does not contain, positive if they
/// turn left about its normal.
Integer area_about(const Vector3<Integer>& normal, const Point3<Integer>& a, const Point3<Integer>& b,
                   const Point3<Integer>& c) {
  using Point = Point3<Integer>;
  const auto projected = [&](int side, Integer Point::*u, Integer Point::*v) {
    return Integer(side * ((b.*u - a.*u) * (c.*v - a.*v) - (b.*v - a.*v) * (c.*u - a.*u)));
  };
  if (sgn(normal.z) != 0) return projected(sgn(normal.z), &Point::x, &Point::y);
  if (sgn(normal.x) != 0) return projected(sgn(normal.x), &Point::y, &Point::z);
  return projected(sgn(normal.y), &Point::z, &Point::x);
}

/// The least point is extreme, and as seen along the last axis all points lie on one side of a line through it and
/// another: the plane through that line contains a face, or an edge.
SupportingPlane first_face(const IntegerCloud& cloud) {
  const Index least = cloud.least();
  SupportingPlane plane{{0, 0, 0}, 0};
  for (Index p = 0; p < cloud.size(); ++p) {
    const Vector3<Integer> v = cloud.between(least, p);
    if (sgn(v.x) == 0 && sgn(v.y) == 0) continue;
    if (zero(plane.normal) || sgn(cloud.height(plane, p)) > 0) plane = cloud.plane({v.y, Integer(-v.x), 0}, least);
  }
  std::optional<Index> farthest;
  for (Index p = 0; p < cloud.size(); ++p) {
    if (cloud[p] == cloud[least] || sgn(cloud.height(plane, p)) != 0) continue;
    if (farthest && !zero(cloud.normal(least, *farthest, p))) return plane;  // three that are not on one line
    if (!farthest || longer(cloud.between(least, p), cloud.between(least, *farthest))) farthest = p;
  }
  return folded(cloud, plane, least, *farthest);
}

}  // namespace

bool before(const Point3<Integer>& p, const Point3<Integer>& q) {
  if (p.x != q.x) return p.x < q.x;
  return p.y != q.y ? p.y < q.y : p.z < q.z;
}

int turn_in(const IntegerCloud& cloud, const SupportingPlane& plane, Index a, Index b, Index c) {
  return sgn(area_about(plane.normal, cloud[a], cloud[b], cloud[c]));
}

IntegerCloud::IntegerCloud(const std::vector<Point3<Rational>>& exactly) {
  IntegerList list = integer_list(numbers_of(exactly));
  for (std::size_t i = 0; i < list.integers.size(); i += 3)
    points.push_back({list.integers[i], list.integers[i + 1], list.integers[i + 2]});
  unit = list.unit;
}

IntegerCloud::IntegerCloud(const std::vector<Point3d>& doubles) {
  IntegerList list = integer_list(numbers_of(doubles));
  for (std::size_t i = 0; i < list.integers.size(); i += 3)
    points.push_back({list.integers[i], list.integers[i + 1], list.integers[i + 2]});
  unit = list.unit;
}

Index IntegerCloud::least() const {
  return static_cast<Index>(std::min_element(points.begin(), points.end(), before) - points.begin());
}

std::vector<Index> IntegerCloud::simplex() const {
  std::vector<Index> found{least()};
  for (Index p = 0; p < size() && found.size() < 4; ++p) {
    const bool wider = found.size() == 1   ? !(points[p] == points[found[0]])
                       : found.size() == 2 ? !zero(normal(found[0], found[1], p))
                                           : sgn(height(plane(normal(found[0], found[1], found[2]), found[0]), p)) != 0;
    if (wider) found.push_back(p);
  }
  return found;
}

std::vector<Index> ends_of(const IntegerCloud& cloud) {
  const auto greatest = std::max_element(cloud.points.begin(), cloud.points.end(), before);
  return {cloud.least(), static_cast<Index>(greatest - cloud.points.begin())};
}

std::vector<Index> ring_in(const IntegerCloud& cloud, const SupportingPlane& plane) {
  std::vector<Index> members;
  for (Index p = 0; p < cloud.size(); ++p) {
    if (sgn(cloud.height(plane, p)) == 0) members.push_back(p);
  }
  std::vector<Index> ring = extreme_ring(
      members, [&](Index p, Index q) { return before(cloud[p], cloud[q]); },
      [&](Index p, Index q, Index r) { return area_about(plane.normal, cloud[p], cloud[q], cloud[r]); });
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

std::vector<std::vector<Index>> face_rings(const IntegerCloud& cloud) {
  std::vector<SupportingPlane> found{first_face(cloud)};
  std::vector<std::vector<Index>> rings;
  std::set<std::pair<Index, Index>> edges;
  const auto add = [&](const SupportingPlane& plane) {
    rings.push_back(ring_in(cloud, plane));
    const std::vector<Index>& ring = rings.back();
    for (std::size_t i = 0; i < ring.size(); ++i) edges.insert({ring[i], ring[(i + 1) % ring.size()]});
  };
  add(found[0]);
  for (std::size_t f = 0; f < rings.size(); ++f) {
    const std::vector<Index> ring = rings[f];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index from = ring[i], to = ring[(i + 1) % ring.size()];
      if (edges.count({to, from}) != 0) continue;
      found.push_back(folded(cloud, found[f], to, from));
      add(found.back());
    }
  }
  return rings;
}

}  // namespace touchstone::oracle
