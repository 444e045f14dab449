// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/polygon_faces.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/nearest_pair.h"
#include "oracle/exact/solids/closed_mesh.h"

namespace touchstone::oracle {
namespace {

using Point = Point3<Rational>;
using Vector = Vector3<Rational>;
using Ring = std::vector<Point>;

Vector area_of(const Point& a, const Point& b, const Point& c) { return cross(b - a, c - a); }

/// True if all corners are in the plane of some three that are not collinear.
bool planar(const Ring& corners) {
  const Point& a = corners[0];
  for (const Point& b : corners) {
    for (const Point& c : corners) {
      const Vector normal = area_of(a, b, c);
      if (zero(normal)) continue;
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Point& d) { return sgn(Rational(dot(normal, d - a))) == 0; });
    }
  }
  return true;
}

/// A triangle in a plane, counter-clockwise about the plane's normal.
struct Piece {
  const Vector& normal;
  const Ring& corners;

  /// Twice the area of an edge and p, times the length of the normal: negative if p is outside.
  Rational within(std::size_t edge, const Point& p) const {
    return Rational(dot(normal, area_of(corners[edge], corners[(edge + 1) % 3], p)));
  }
  bool has_weights_of(const Point& p) const {
    return sgn(within(0, p)) >= 0 && sgn(within(1, p)) >= 0 && sgn(within(2, p)) >= 0;
  }
  bool is_corner(const Point& p) const { return std::find(corners.begin(), corners.end(), p) != corners.end(); }
};

/// The part of the ring within an edge of the triangle.
Ring clipped(const Ring& ring, const Piece& by, std::size_t edge) {
  Ring left;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
    const Rational at_p = by.within(edge, p), at_q = by.within(edge, q);
    if (sgn(at_p) >= 0) left.push_back(p);
    if (sgn(at_p) * sgn(at_q) < 0) {
      const Rational t(at_p / (at_p - at_q));
      left.push_back(p + t * (q - p));
    }
  }
  return left;
}

bool overlap(const Piece& one, const Piece& other) {
  Ring common = one.corners;
  for (std::size_t edge = 0; edge < 3; ++edge) common = clipped(common, other, edge);
  for (std::size_t k = 1; k + 1 < common.size(); ++k)
    if (!zero(area_of(common[0], common[k], common[k + 1]))) return true;
  return false;
}

/// The count of each edge's traversals, forward minus backward.
using Boundary = std::map<std::pair<Index, Index>, std::int64_t>;

void run(Boundary& boundary, Index from, Index to) {
  const auto [edge, fresh] = boundary.try_emplace(std::minmax(from, to), 0);
  edge->second += from < to ? 1 : -1;
  if (edge->second == 0) boundary.erase(edge);
}

bool cuts(const std::vector<Index>& corners, const Ring& polygon, const std::vector<Face>& triangles,
          const std::vector<Ring>& pieces) {
  const std::set<Index> named(corners.begin(), corners.end());
  Boundary of_polygon, of_triangles;
  for (std::size_t k = 0; k < corners.size(); ++k) run(of_polygon, corners[k], corners[(k + 1) % corners.size()]);
  for (const Face& face : triangles) {
    for (const auto& [from, to] : edges_of(face)) {
      if (!named.contains(from)) return false;
      run(of_triangles, from, to);
    }
  }
  if (of_polygon != of_triangles) return false;
  const Vector normal = area_of(pieces[0][0], pieces[0][1], pieces[0][2]);
  if (zero(normal)) return false;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece piece{normal, pieces[i]};
    if (sgn(piece.within(0, pieces[i][2])) <= 0) return false;
    for (const Point& p : polygon)
      if (!piece.is_corner(p) && piece.has_weights_of(p)) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(piece, {normal, pieces[j]})) return false;
  }
  return true;
}

template <class Number>
void validate_polygons_of(const std::string& field, const Mesh<Number>& mesh) {
  const auto at = [&mesh](Index v) { return exact(mesh.vertices[v]); };
  auto next = mesh.faces.begin();
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const std::vector<Index>& corners = mesh.polygons[i];
    const std::vector<Face> triangles(next, next + static_cast<std::ptrdiff_t>(corners.size()) - 2);
    next += static_cast<std::ptrdiff_t>(triangles.size());
    if (corners.size() == 3) {
      if (!(triangles[0] == Face{corners[0], corners[1], corners[2]})) validation::refuse_cut(field);
      continue;
    }
    Ring polygon;
    std::vector<Ring> pieces;
    for (const Index v : corners) polygon.push_back(at(v));
    for (const Face& f : triangles) pieces.push_back({at(f.a), at(f.b), at(f.c)});
    if (!planar(polygon)) validation::refuse_askew(field, i);
    if (!cuts(corners, polygon, triangles, pieces)) validation::refuse_cut(field);
  }
}

}  // namespace

void validate_polygons(const std::string& field, const Mesh<Rational>& mesh) { validate_polygons_of(field, mesh); }
void validate_polygons(const std::string& field, const Meshd& mesh) { validate_polygons_of(field, mesh); }

FacePart face_part(const std::vector<Point3<Rational>>& corners, const Point3<Rational>& x) {
  if (std::find(corners.begin(), corners.end(), x) != corners.end()) return FacePart::vertex;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Hull edge{corners[k], corners[(k + 1) % corners.size()]};
    if (sgn(nearest_pair(edge, {x}).squared_distance) == 0) return FacePart::edge;
  }
  return FacePart::inside;
}

}  // namespace touchstone::oracle
