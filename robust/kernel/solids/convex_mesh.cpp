// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/solids/convex_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/enclosed/enclosed_crossing.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::robust::kernel {
namespace {

std::array<Index, 4> ring_of(const Face& face) { return {face.a, face.b, face.c, face.a}; }

/// The directed edges of triangles; edge 3 i + k leads from corner k of face i to the next.
class DirectedEdges {
 public:
  explicit DirectedEdges(const Meshd& mesh)
      : faces_(mesh.faces),
        first_(mesh.vertices.size() + 2, 0),
        leaving_(3 * faces_.size()),
        reverse_(3 * faces_.size()) {
    for (const auto& [a, b, c] : faces_)
      for (const Index from : {a, b, c}) ++first_[from + 2];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::uint32_t edge = 0;
    for (const auto& [a, b, c] : faces_)
      for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) leaving_[first_[from + 1]++] = {to, edge++};
    edge = 0;
    for (const auto& [a, b, c] : faces_)
      for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) closed_ &= find(to, from, reverse_[edge++]) == 1;
  }

  /// True if the reverse of each occurs once, and with it each itself.
  bool closed() const { return closed_; }
  bool once(Index from, Index to) const {
    std::uint32_t found = 0;
    return find(from, to, found) == 1;
  }
  bool starts_any(Index from) const { return first_[from] != first_[from + 1]; }
  /// The vertex opposite an edge in the other face that has it.
  Index across(std::size_t edge) const {
    const Face& other = faces_[reverse_[edge] / 3];
    return std::array{other.c, other.a, other.b}[reverse_[edge] % 3];
  }

 private:
  struct Edge {
    Index to;
    std::uint32_t edge;
  };

  /// How often it occurs, and where.
  int find(Index from, Index to, std::uint32_t& found) const {
    int count = 0;
    for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i) {
      const bool same = leaving_[i].to == to;
      count += static_cast<int>(same), found = same ? leaving_[i].edge : found;
    }
    return count;
  }

  const std::vector<Face>& faces_;
  std::vector<std::uint32_t> first_;  // of the edges that leave each vertex
  std::vector<Edge> leaving_;
  std::vector<std::uint32_t> reverse_;
  bool closed_ = true;
};

void validate_closed(const std::string& field, const Meshd& mesh, const DirectedEdges& edges) {
  if (edges.closed()) return;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto ring = ring_of(mesh.faces[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!edges.once(ring[k], ring[k + 1]) || !edges.once(ring[k + 1], ring[k]))
        validation::refuse_edge(field, mesh, i, ring[k], ring[k + 1]);
    }
  }
}

bool has_area(const Meshd& mesh, const Face& face) {
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b], &c = mesh.vertices[face.c];
  const auto n = integers_of(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z).at;
  const auto zero = [&n](std::size_t x, std::size_t y) {
    return sgn(mpz_class((n[3 + x] - n[x]) * (n[6 + y] - n[y]) - (n[3 + y] - n[y]) * (n[6 + x] - n[x]))) == 0;
  };
  return !(zero(0, 1) && zero(1, 2) && zero(2, 0));
}

void validate_areas(const std::string& field, const Meshd& mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    if (!has_area(mesh, mesh.faces[i])) validation::refuse_area(field, mesh, i);
  }
}

/// Asks each edge instead of each vertex about each face. A point o is below all faces, so from o they are all seen the
/// same way round, and every ray from o meets as many of them as the closed surface, all its parts together, winds
/// around o. If one ray meets one face, all do, and the surface is a function of the direction from o. It is convex if
/// it bends at no edge outwards.
/// (Mehlhorn et al., "Checking geometric programs or verification of geometric structures", 1999.)
class ConvexByEdges {
 public:
  ConvexByEdges(const Meshd& mesh, const DirectedEdges& edges) : mesh_(mesh), edges_(edges) {}

  /// The side of the outside, as validate_convex returns it; 0 if the mesh is not certainly convex.
  int outside(Stage& latest) const {
    for (Index i = 0; i < mesh_.vertices.size(); ++i)
      if (!edges_.starts_any(i) || !crossable(mesh_.vertices[i])) return 0;
    const Point3d middle = mean();
    const int inside = FaceSide(mesh_, mesh_.faces[0]).surely(middle);
    if (inside == 0 || !meets_one_face(middle, inside)) return 0;
    Stage needed = latest;
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
      const FaceSide plane(mesh_, mesh_.faces[i]);
      if (plane.surely(middle) != inside) return 0;
      const auto ring = ring_of(mesh_.faces[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        if (ring[k] < ring[k + 1] && plane.of(mesh_.vertices[edges_.across(3 * i + k)]).noting(needed) == -inside)
          return 0;
      }
    }
    latest = needed;
    return -inside;
  }

 private:
  /// About the mean of the vertices, whose coordinates are not tiny: any point inside will do.
  Point3d mean() const {
    double x = 0, y = 0, z = 0, extent = 0;
    for (const Point3d& p : mesh_.vertices) {
      x += p.x, y += p.y, z += p.z;
      extent = std::max({extent, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    const auto count = static_cast<double>(mesh_.vertices.size());
    const auto part = [&](double sum) { return std::fabs(sum) < count * extent * 0x1p-20 ? 0.0 : sum / count; };
    return {part(x), part(y), part(z)};
  }

  /// True if the ray from o towards about the middle of the first face certainly passes through one face and misses
  /// all others: three planes through o bound the cone of a face. The parts of both points are means of `crossable`
  /// numbers, or 0: multiples of 2^-190, so that no product is below 2^-570.
  bool meets_one_face(const Point3d& o, int inside) const {
    const auto [a, b, c] = corners(mesh_.faces[0]);
    const Point3d target{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    const auto ray = filters::sized_between(o, target);
    int met = 0;
    for (const Face& face : mesh_.faces) {
      const auto [p, q, r] = corners(face);
      const auto to_p = filters::sized_between(o, p), to_q = filters::sized_between(o, q),
                 to_r = filters::sized_between(o, r);
      const auto pq = dot(ray, cross(to_p, to_q)), qr = dot(ray, cross(to_q, to_r)), rp = dot(ray, cross(to_r, to_p));
      const bool front = inside < 0;
      const auto within = [front](const auto& side) { return front ? side.positive() : side.negative(); };
      const auto missed = [front](const auto& side) { return front ? side.negative() : side.positive(); };
      if (missed(pq) | missed(qr) | missed(rp)) continue;
      if (!(within(pq) & within(qr) & within(rp))) return false;
      ++met;
    }
    return met == 1;
  }
  std::array<Point3d, 3> corners(const Face& f) const {
    return {mesh_.vertices[f.a], mesh_.vertices[f.b], mesh_.vertices[f.c]};
  }

  const Meshd& mesh_;
  const DirectedEdges& edges_;
};

}  // namespace

int validate_convex(const std::string& field, const Meshd& mesh, Stage& latest) {
  return validate_convex_surface(field, mesh, latest).outside;
}

ConvexSurface validate_convex_surface(const std::string& field, const Meshd& mesh, Stage& latest) {
  validation::validate(field, mesh), validate_polygons(field, mesh);
  validation::validate_triangles(field, mesh);
  const DirectedEdges edges(mesh);
  validate_closed(field, mesh, edges);
  if (const int outside = ConvexByEdges(mesh, edges).outside(latest); outside != 0) return {outside, true};
  int outside = 0;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& face = mesh.faces[i];
    const FaceSide plane(mesh, face);
    bool off = false;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (v == face.a || v == face.b || v == face.c) continue;
      const int side = plane.of(mesh.vertices[v]).noting(latest);
      if (side == 0) continue;
      off = true;
      if (outside == 0) outside = -side;
      if (side == outside) validate_areas(field, mesh), validation::refuse_beyond(field, mesh, i, v);
    }
    // If the mesh has no area no vertex is off the plane; if face 0 has one, a vertex is off, and with it one for every
    // face that has an area.
    if (!off) validate_areas(field, mesh), validation::refuse_flat_mesh(field);
  }
  return {outside, false};
}

}  // namespace touchstone::robust::kernel
