// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/polygon_faces.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/filters.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/plane.h"

namespace touchstone::robust::kernel {

int sign_of_turn(const Point2d& p, const Point2d& q, const Point2d& r) {
  if (const auto sign = filters::by_sign(filters::orientation(p, q, r), 1, -1)) return *sign;
  const auto n = integers_of(p.x, p.y, q.x, q.y, r.x, r.y).at;
  return turn(Point2<mpz_class>{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]});
}

int sign_of_turn(const Point2<mpq_class>& p, const Point2<mpq_class>& q, const Point2<mpq_class>& r) {
  return sgn(mpq_class((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)));
}

bool in_one_plane(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& d) {
  if (filters::by_sign(filters::FacePlane<double>(a, b, c).side(d), 1, -1)) return false;
  return SideOfFace::exact(a, b, c, d) == 0;
}

bool in_one_plane(const Point3<mpq_class>& a, const Point3<mpq_class>& b, const Point3<mpq_class>& c,
                  const Point3<mpq_class>& d) {
  const Vector3<mpq_class> u = b - a, v = c - a, w = d - a;
  return sgn(mpq_class(dot(cross(u, v), w))) == 0;
}

template <class Real>
std::optional<ProjectedPolygon<Real>> ProjectedPolygon<Real>::of(const std::vector<Point3<Real>>& vertices,
                                                                 const std::vector<Index>& corners) {
  using P = Point3<Real>;
  const ProjectedPolygon along[]{{vertices, &P::x, &P::y}, {vertices, &P::y, &P::z}, {vertices, &P::z, &P::x}};
  const Index a = corners[0];
  const auto b = std::find_if(corners.begin(), corners.end(), [&](Index v) { return !(vertices[v] == vertices[a]); });
  for (auto c = b; c != corners.end(); ++c) {
    for (const ProjectedPolygon& projected : along) {
      if (projected.turn_of(a, *b, *c) == 0) continue;
      const bool planar = std::all_of(corners.begin(), corners.end(), [&](Index d) {
        return d == a || d == *b || d == *c || in_one_plane(vertices[a], vertices[*b], vertices[*c], vertices[d]);
      });
      return planar ? std::optional(projected) : std::nullopt;
    }
  }
  return along[0];  // all collinear
}

namespace {

using Triangles = std::span<const Face>;

std::array<Index, 4> ring_of(const Face& face) { return {face.a, face.b, face.c, face.a}; }

/// True if the triangles and the polygon traverse every edge equally often, forward minus backward: then the triangles
/// bound the same area as the polygon.
bool bounded_alike(const std::vector<Index>& corners, Triangles triangles) {
  std::vector<std::tuple<Index, Index, int>> runs;
  const auto add = [&runs](Index from, Index to, int times) {
    runs.emplace_back(std::min(from, to), std::max(from, to), from < to ? times : -times);
  };
  for (const Face& face : triangles) {
    const auto ring = ring_of(face);
    for (std::size_t k = 0; k < 3; ++k) add(ring[k], ring[k + 1], 1);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) add(corners[k], corners[(k + 1) % corners.size()], -1);
  std::sort(runs.begin(), runs.end());
  for (std::size_t first = 0, last = 0; first < runs.size(); first = last) {
    const auto& [low, high, one] = runs[first];
    int sum = 0;
    for (; last < runs.size() && std::get<0>(runs[last]) == low && std::get<1>(runs[last]) == high; ++last)
      sum += std::get<2>(runs[last]);
    if (sum != 0) return false;
  }
  return true;
}

/// True if all turns of triangles are positive with this sign.
template <class Real>
struct Cut {
  const ProjectedPolygon<Real>& projected;
  int sign;

  int turn(Index p, Index q, Index r) const { return sign * projected.turn_of(p, q, r); }
  /// True if an edge of one has all of the other on its right.
  bool held_apart(const Face& one, const Face& other) const {
    const auto ring = ring_of(one);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto right = [&](Index v) { return turn(ring[k], ring[k + 1], v) <= 0; };
      if (right(other.a) && right(other.b) && right(other.c)) return true;
    }
    return false;
  }
  bool holds(const Face& f, Index v) const {
    const auto same = [&](Index corner) { return projected.in_one_position(corner, v); };
    if (same(f.a) || same(f.b) || same(f.c)) return false;
    return turn(f.a, f.b, v) >= 0 && turn(f.b, f.c, v) >= 0 && turn(f.c, f.a, v) >= 0;
  }
};

template <class Real>
bool cuts(const ProjectedPolygon<Real>& projected, const std::vector<Index>& corners, Triangles triangles) {
  const Cut<Real> cut{projected, projected.turn_of(triangles[0].a, triangles[0].b, triangles[0].c)};
  const auto named = [&corners](Index v) { return std::find(corners.begin(), corners.end(), v) != corners.end(); };
  for (const Face& f : triangles)
    if (!named(f.a) || !named(f.b) || !named(f.c) || cut.turn(f.a, f.b, f.c) <= 0) return false;
  if (!bounded_alike(corners, triangles)) return false;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Face& f = triangles[i];
    if (std::any_of(corners.begin(), corners.end(), [&](Index v) { return cut.holds(f, v); })) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (!cut.held_apart(f, triangles[j]) && !cut.held_apart(triangles[j], f)) return false;
  }
  return true;
}

}  // namespace

template <class Real>
std::variant<std::vector<Face>, PolygonDefect> cut_polygon(const std::vector<Point3<Real>>& vertices,
                                                           const std::vector<Index>& corners) {
  struct Ring {
    const ProjectedPolygon<Real>& projected;
    const std::vector<Index>& corners;
    int sign;
    int turn(std::size_t i, std::size_t j, std::size_t k) const {
      return sign * projected.turn_of(corners[i], corners[j], corners[k]);
    }
    bool same(std::size_t i, std::size_t j) const { return projected.in_one_position(corners[i], corners[j]); }
  };
  const ControlWord ieee;
  const auto projected = ProjectedPolygon<Real>::of(vertices, corners);
  if (!projected) return PolygonDefect::askew;
  for (const int sign : {1, -1}) {
    const auto triangles = clipped_ears(Ring{*projected, corners, sign}, corners.size());
    if (!triangles) continue;
    std::vector<Face> faces;
    for (const auto& [i, j, k] : *triangles) faces.push_back({corners[i], corners[j], corners[k]});
    if (cuts(*projected, corners, Triangles(faces))) return faces;
  }
  return PolygonDefect::no_ring;
}

template std::variant<std::vector<Face>, PolygonDefect> cut_polygon(const std::vector<Point3d>&,
                                                                    const std::vector<Index>&);
template std::variant<std::vector<Face>, PolygonDefect> cut_polygon(const std::vector<Point3<mpq_class>>&,
                                                                    const std::vector<Index>&);

void validate_polygons(const std::string& field, const Meshd& mesh) {
  const ControlWord ieee;
  Triangles left(mesh.faces);
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const std::vector<Index>& corners = mesh.polygons[i];
    const Triangles triangles = left.first(corners.size() - 2);
    left = left.subspan(triangles.size());
    const Face& first = triangles[0];
    if (corners.size() == 3) {
      if (corners != std::vector<Index>{first.a, first.b, first.c}) validation::refuse_cut(field);
      continue;
    }
    const auto projected = ProjectedPolygon<double>::of(mesh.vertices, corners);
    if (!projected) validation::refuse_askew(field, i);
    if (!cuts(*projected, corners, triangles)) validation::refuse_cut(field);
  }
}

}  // namespace touchstone::robust::kernel
