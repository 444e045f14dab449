// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/convex_hull.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "geometry/validation.h"
#include "oracle/exact/shapes/extreme_ring.h"
#include "oracle/exact/shapes/whole_cloud.h"

namespace touchstone::oracle {
namespace {

void validate_convex_hull(const std::vector<Point3d>& points) { validation::validate("points", points, rule::points); }
void validate_convex_hull(const std::vector<Point3<Rational>>& points) {
  if (points.empty()) throw InvalidInput("points", "at least 1 point");
}

Integer greatest(const Vector3<Integer>& v) {
  return std::max({Integer(abs(v.x)), Integer(abs(v.y)), Integer(abs(v.z))});
}

/// The rings of the faces; empty if all points are coplanar.
using Rings = std::vector<std::vector<Index>>;

/// The margin in units to the third power.
std::optional<Integer> margin_of_convex_hull(const IntegerCloud& cloud, const Rings& rings) {
  if (cloud.size() == 1) return std::nullopt;
  const Integer width = greatest(cloud.between(0, 1));
  if (cloud.size() == 2) return Integer(width * width * width);
  if (cloud.size() == 3)
    return Integer(greatest(cloud.normal(0, 1, 2)) * std::max(width, greatest(cloud.between(0, 2))));
  if (rings.empty()) return Integer(0);
  std::optional<Integer> least;
  for (std::size_t f = 0; f < rings.size(); ++f) {
    if (rings[f].size() > 3) return Integer(0);
    const SupportingPlane plane = cloud.plane(cloud.normal(rings[f][0], rings[f][1], rings[f][2]), rings[f][0]);
    for (Index p = 0; p < cloud.size(); ++p) {
      if (std::find(rings[f].begin(), rings[f].end(), p) != rings[f].end()) continue;
      Integer size = abs(cloud.height(plane, p));
      if (!least || size < *least) least = std::move(size);
    }
  }
  return least;
}

ConvexHull hull_of_convex_hull(const IntegerCloud& cloud, const std::vector<Index>& simplex, const Rings& rings) {
  if (simplex.size() == 1) return {0, simplex[0], {}, {}, {}};
  if (simplex.size() == 2) {
    const std::vector<Index> ends = ends_of(cloud);
    return {1, {}, IndexPair{ends[0], ends[1]}, {}, {}};
  }
  if (simplex.size() == 3)
    return {2, {}, {}, ring_in(cloud, cloud.plane(cloud.normal(simplex[0], simplex[1], simplex[2]), simplex[0])), {}};
  std::vector<Face> faces;
  for (const auto& ring : rings) {
    for (std::size_t i = 2; i < ring.size(); ++i) faces.push_back({ring[0], ring[i - 1], ring[i]});
  }
  std::sort(faces.begin(), faces.end(), [](const Face& f, const Face& g) {
    return std::array{f.a, f.b, f.c} < std::array{g.a, g.b, g.c};
  });
  return {3, {}, {}, {}, faces};
}

/// The distinct indices of an answer; empty if its fields are not those of its dimension.
std::vector<Index> named_by_convex_hull(const ConvexHull& hull) {
  if (hull.point.has_value() != (hull.dimension == 0) || hull.segment.has_value() != (hull.dimension == 1) ||
      hull.polygon.has_value() != (hull.dimension == 2) || hull.faces.has_value() != (hull.dimension == 3)) {
    return {};
  }
  if (hull.point) return {*hull.point};
  if (hull.segment) return {hull.segment->i, hull.segment->j};
  if (hull.polygon) return *hull.polygon;
  std::set<Index> named;
  for (const Face& f : hull.faces.value_or(std::vector<Face>())) named.insert({f.a, f.b, f.c});
  return {named.begin(), named.end()};
}

const char* kind_of(const ConvexHull& hull) {
  static constexpr std::array kinds{"one_point", "segment", "polygon", "faces"};
  return kinds[hull.dimension];
}

std::string outside(Index p) { return "outside is point " + std::to_string(p); }

/// Requires a ring that turns left about the normal of its plane, which contains all points, with every point on the
/// left of every edge or on it: as in convex_hull_2d.cpp.
std::string polygon_defect(const IntegerCloud& cloud, const std::vector<Index>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return "fewer than three vertices";
  const SupportingPlane plane = cloud.plane(cloud.normal(ring[0], ring[1], ring[2]), ring[0]);
  if (zero(plane.normal)) return "no turn at a corner";
  const auto turn = [&](Index a, Index b, Index c) { return turn_in(cloud, plane, a, b, c); };
  for (std::size_t k = 0; k < n; ++k)
    if (turn(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) <= 0) return "no turn to the left";
  for (Index p = 0; p < cloud.size(); ++p)
    if (sgn(cloud.height(plane, p)) != 0) return outside(p);
  const auto beyond = point_outside(
      ring, cloud.size(), [&](Index p, Index q) { return before(cloud[p], cloud[q]); }, turn);
  return beyond ? outside(*beyond) : "";
}

/// True if the normals of the faces at a corner span space: then it is the one point that all their planes have in
/// common.
bool is_extreme(const std::vector<Vector3<Integer>>& normals) {
  std::optional<Vector3<Integer>> across;  // the direction of the planes so far
  for (const Vector3<Integer>& n : normals) {
    if (across && sgn(dot(*across, n)) != 0) return true;
    if (!across && !zero(cross(normals[0], n))) across = cross(normals[0], n);
  }
  return false;
}

/// Triangles of positive area with all points below them or in their planes lie on the boundary of the hull and face
/// outwards. If every edge is there once in each direction, they have no rim, so they cover all of the boundary, every
/// part of it as often. Corners that are extreme, and different points, leave no edge of the hull but between two of
/// them, and it is there once: they cover it once. And what covers the boundary has all extreme points as corners.
std::string faces_defect(const IntegerCloud& cloud, const std::vector<Face>& faces) {
  std::set<std::pair<Index, Index>> edges;
  std::map<Index, std::vector<Vector3<Integer>>> normals;
  bool inside = false;
  for (const Face& f : faces) {
    for (const auto& edge : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}}) {
      if (!edges.insert(edge).second) return "an edge twice";
    }
    const SupportingPlane plane = cloud.plane(cloud.normal(f.a, f.b, f.c), f.a);
    if (zero(plane.normal)) return "a face without area";
    for (const Index corner : {f.a, f.b, f.c}) normals[corner].push_back(plane.normal);
    for (Index p = 0; p < cloud.size(); ++p) {
      const int side = sgn(cloud.height(plane, p));
      if (side > 0) return outside(p);
      inside = inside || side < 0;
    }
  }
  if (!inside) return "no solid";
  for (const auto& [from, to] : edges) {
    if (edges.count({to, from}) == 0) return "not closed";
  }
  for (const auto& [corner, around] : normals) {
    if (!is_extreme(around)) return "not extreme is point " + std::to_string(corner);
  }
  return "";
}

}  // namespace

template <Exact Number>
Truth<ConvexHull> convex_hull(const std::vector<Point3<Number>>& points) {
  validate_convex_hull(points);
  const IntegerCloud cloud(points);
  const std::vector<Index> simplex = cloud.simplex();
  const Rings rings = simplex.size() < 4 ? Rings() : face_rings(cloud);
  Truth<ConvexHull> found{hull_of_convex_hull(cloud, simplex, rings), std::nullopt};
  if (const auto margin = margin_of_convex_hull(cloud, rings))
    found.margin = Rational(Rational(*margin) * cloud.unit * cloud.unit * cloud.unit);
  found.certificate = [hull = found.answer] {
    const std::vector<Index> named = named_by_convex_hull(hull);
    return Certificate{kind_of(hull), {{"extreme", {named.begin(), named.end()}}}};
  };
  return found;
}
template Truth<ConvexHull> convex_hull(const std::vector<Point3d>&);
template Truth<ConvexHull> convex_hull(const std::vector<Point3<Rational>>&);

std::string convex_hull_defect(const std::vector<Point3d>& points, const ConvexHull& hull) {
  const std::vector<Index> named = named_by_convex_hull(hull);
  if (named.empty()) return "not the fields of its dimension";
  const IntegerCloud cloud(points);
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i] >= cloud.size()) return "no such point: " + std::to_string(named[i]);
    for (std::size_t k = 0; k < i; ++k) {
      if (cloud[named[i]] == cloud[named[k]]) return "one point twice: " + std::to_string(named[i]);
    }
  }
  if (hull.faces) return faces_defect(cloud, *hull.faces);
  if (hull.polygon) return polygon_defect(cloud, named);
  for (Index p = 0; p < cloud.size(); ++p) {
    const Vector3<Integer> v = cloud.between(p, named[0]), w = cloud.between(p, named.back());
    if (named.size() == 1 ? !zero(v) : !zero(cross(v, w)) || sgn(dot(v, w)) > 0) return outside(p);
  }
  return "";
}

}  // namespace touchstone::oracle
