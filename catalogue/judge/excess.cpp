// SPDX-License-Identifier: Apache-2.0
#include "catalogue/judge/excess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <set>

#include "catalogue/judge/wide.h"
#include "geometry/validation.h"

namespace touchstone::catalogue {
namespace {

using Real = long double;
using Place = Point3<Real>;
using Indices = std::vector<Index>;

Place place(const Point3d& p) { return {p.x, p.y, p.z}; }
Place place(const Point2d& p) { return {p.x, p.y, 0}; }

template <class Point>
std::vector<Place> places(const std::vector<Point>& points) {
  std::vector<Place> all;
  for (const Point& p : points) all.push_back(place(p));
  return all;
}

Real greatest_part(const Displacement& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
Real size_of(const std::vector<Place>& points) {
  Real size = 0;
  for (const Place& p : points) size = std::max(size, greatest_part(p - Place{0, 0, 0}));
  return size;
}

/// NaN and infinities cannot be compared.
Excess excess(Real value) {
  if (!std::isfinite(value)) return std::nullopt;
  return static_cast<double>(std::max<Real>(value, 0));
}

/// True if they name different points of the list.
bool named(const std::vector<Place>& points, const Indices& named) {
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (named[i] >= points.size()) return false;
    for (std::size_t k = 0; k < i; ++k)
      if (points[named[i]] == points[named[k]]) return false;
  }
  return !named.empty();
}

/// The excess of the two ends of collinear points, or of the one point to which all are equal.
Excess excess_of_ends(const std::vector<Place>& points, const Place& a, const Place& b) {
  const Real size = size_of(points);
  Real most = 0;
  for (const Place& p : points) {
    if (a == b) most = std::max(most, greatest_part(p - a) / size);
    else most = std::max({most, greatest_part(cross(p - a, b - a)) / size / size, dot(a - p, b - p) / size / size});
  }
  return excess(most);
}

/// The excess of a ring around coplanar points, all of which must be on the left of each edge about the ring's normal.
Excess excess_of_ring(const std::vector<Place>& points, const Indices& ring) {
  if (ring.size() < 3) return std::nullopt;
  const Real size = size_of(points);
  const auto at = [&](std::size_t k) { return points[ring[k % ring.size()]]; };
  Displacement normal{0, 0, 0};
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) normal = normal + cross(at(k) - at(0), at(k + 1) - at(0));
  Real most = 0;
  for (const Place& p : points) {
    most = std::max(most, std::fabs(dot(normal, p - at(0))) / size / size / size);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Displacement turn = cross(at(k + 1) - at(k), p - at(k));
      // A ring without area is collinear, or not a ring.
      const Real wrong_side = wide_length(normal) > 0 ? -dot(normal, turn) / wide_length(normal) : wide_length(turn);
      most = std::max(most, wrong_side / size / size);
    }
  }
  return excess(most);
}

/// The excess of triangles around points, all of which must be below each or in its plane. Each edge must occur once in
/// each direction.
Excess excess_of_faces(const std::vector<Place>& points, const std::vector<Face>& faces) {
  std::set<std::pair<Index, Index>> edges;
  for (const Face& f : faces)
    for (const auto& edge : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}})
      if (!edges.insert(edge).second) return std::nullopt;
  for (const auto& [from, to] : edges)
    if (edges.count({to, from}) == 0) return std::nullopt;
  const Real size = size_of(points);
  Real most = 0;
  for (const Face& f : faces) {
    const Place& a = points[f.a];
    const Displacement normal = cross(points[f.b] - a, points[f.c] - a);
    for (const Place& p : points) most = std::max(most, dot(normal, p - a) / size / size / size);
  }
  return excess(most);
}

Indices corners(const std::vector<Face>& faces) {
  std::set<Index> all;
  for (const Face& f : faces) all.insert({f.a, f.b, f.c});
  return {all.begin(), all.end()};
}

/// The part that both kinds of hulls share.
Excess excess_of_flat(const std::vector<Place>& points, const auto& hull) {
  const bool fields = hull.point.has_value() == (hull.dimension == 0) &&
                      hull.segment.has_value() == (hull.dimension == 1) &&
                      hull.polygon.has_value() == (hull.dimension == 2);
  if (!fields) return std::nullopt;
  const Indices ring = hull.point     ? Indices{*hull.point}
                       : hull.segment ? Indices{hull.segment->i, hull.segment->j}
                                      : hull.polygon.value_or(Indices());
  if (!named(points, ring)) return std::nullopt;
  return hull.polygon ? excess_of_ring(points, ring) : excess_of_ends(points, points[ring[0]], points[ring.back()]);
}

}  // namespace

Excess excess_of_hull(const std::vector<Point3d>& points, const ConvexHull& hull) {
  const std::vector<Place> all = places(points);
  if (hull.faces.has_value() != (hull.dimension == 3)) return std::nullopt;
  if (!hull.faces) return excess_of_flat(all, hull);
  if (hull.point || hull.segment || hull.polygon || !named(all, corners(*hull.faces))) return std::nullopt;
  return excess_of_faces(all, *hull.faces);
}

Excess excess_of_hull(const std::vector<Point2d>& points, const ConvexHull2& hull) {
  const std::vector<Place> all = places(points);
  const Excess flat = excess_of_flat(all, hull);
  if (!flat || !hull.polygon) return flat;
  Real doubled_area = 0;
  const Indices& ring = *hull.polygon;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
    doubled_area += cross(all[ring[k]] - all[ring[0]], all[ring[k + 1]] - all[ring[0]]).z;
  const Real size = size_of(all);
  return excess(std::max<Real>(*flat, -doubled_area / size / size));  // clockwise by this much
}

Excess excess_of_pieces(const std::tuple<Polygon2d>& question, const std::vector<std::vector<Index>>& pieces,
                        const std::vector<std::vector<Index>>&) {
  const std::vector<Place> ring = places((*validation::OpenRing(std::get<0>(question))).vertices);
  const Real size = size_of(ring);
  const auto turn = [&](Index a, Index b, Index c) { return cross(ring[b] - ring[a], ring[c] - ring[a]).z; };
  const auto area = [&](const Indices& piece) {
    Real sum = 0;
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) sum += turn(piece[0], piece[k], piece[k + 1]);
    return sum;
  };
  Real not_convex = 0, sum = 0, nearest = HUGE_VALL;
  for (const Indices& piece : pieces) {
    if (piece.size() < 3 || !named(ring, piece)) return std::nullopt;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const Index a = piece[k], b = piece[(k + 1) % piece.size()];
      for (const Index c : piece) not_convex = std::max(not_convex, -turn(a, b, c));
      for (Index c = 0; c < ring.size(); ++c)
        if (c != a && c != b) nearest = std::min(nearest, std::fabs(turn(a, b, c)));
    }
    sum += area(piece);
  }
  Indices whole(ring.size());
  for (Index k = 0; k < ring.size(); ++k) whole[k] = k;
  const Real gap = std::fabs(sum - std::fabs(area(whole)));
  // If areas add up, an edge is on the wrong side of a vertex: at least of the nearest.
  const bool adds_up = gap <= 0x1p-60L * size * size * static_cast<Real>(ring.size());
  return excess(std::max({not_convex, gap, adds_up && not_convex == 0 ? nearest : 0}) / size / size);
}

Excess excess_of_ball(const std::vector<Point3d>& points, const Sphere3d& ball, const Sphere3d& right) {
  const std::vector<Place> all = places(points);
  Real beyond = Real(ball.radius) - right.radius;
  for (const Place& p : all) beyond = std::max(beyond, wide_length(p - place(ball.center)) - ball.radius);
  return excess(beyond / size_of(all));
}

Excess excess_of_slabs(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals,
                       const std::vector<Slabd>& slabs) {
  if (slabs.size() != normals.size()) return std::nullopt;
  Real most = 0;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    Real low = HUGE_VALL, high = -HUGE_VALL, size = 0;
    for (const Point3d& p : points) {
      const Real x = Real(normals[i].x) * p.x, y = Real(normals[i].y) * p.y, z = Real(normals[i].z) * p.z;
      low = std::min(low, x + y + z), high = std::max(high, x + y + z);
      size = std::max(size, std::fabs(x) + std::fabs(y) + std::fabs(z));
    }
    const Real off = std::max(std::fabs(low - slabs[i].min), std::fabs(high - slabs[i].max));
    if (!std::isfinite(off)) return std::nullopt;
    if (off > 0) most = std::max(most, off / size);
  }
  return excess(most);
}

Excess excess_of_box(const std::vector<Point3d>& points, const Obb3d& box) {
  const std::vector<Place> all = places(points);
  const Real size = size_of(all);
  const std::array<Displacement, 3> axes{displacement(box.half_axes.u), displacement(box.half_axes.v),
                                         displacement(box.half_axes.w)};
  Real most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real along = dot(axes[k], axes[(k + 1) % 3]), lengths = wide_length(axes[k]) * wide_length(axes[(k + 1) % 3]);
    if (std::fabs(along) > 0x1p-19L * lengths) return std::nullopt;  // far from perpendicular
  }
  std::array<Real, 3> farthest{0, 0, 0};
  for (const Place& p : all) {
    Displacement rest = p - place(box.center);  // the rest that the nonzero axes leave
    for (std::size_t k = 0; k < 3; ++k) {
      const Real square = dot(axes[k], axes[k]);
      if (square == 0) continue;
      const Real along = dot(rest, axes[k]) / square;
      farthest[k] = std::max(farthest[k], std::fabs(along));
      rest = rest - along * axes[k];
    }
    most = std::max(most, wide_length(rest));
  }
  for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::fabs(farthest[k] - 1) * wide_length(axes[k]));
  return excess(most / size);
}

}  // namespace touchstone::catalogue
