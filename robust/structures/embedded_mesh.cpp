// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/embedded_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/solids/small_hulls.h"
#include "robust/lines/orientation.h"
#include "robust/structures/near_faces.h"
#include "robust/structures/sort_and_sweep.h"

namespace touchstone::robust::structures {
namespace {

Triangle3d triangle_of(const Meshd& mesh, const Face& f) {
  return {mesh.vertices[f.a], mesh.vertices[f.b], mesh.vertices[f.c]};
}

/// True if the corners are collinear in the projections along every axis.
bool flat(const Triangle3d& t) {
  const auto on_one_line = [&t](double Point3d::*u, double Point3d::*v) {
    const auto seen = [u, v](const Point3d& p) { return Point2d{p.*u, p.*v}; };
    return orientation(seen(t.a), seen(t.b), seen(t.c)) == Side::on;
  };
  return on_one_line(&Point3d::x, &Point3d::y) && on_one_line(&Point3d::y, &Point3d::z) &&
         on_one_line(&Point3d::z, &Point3d::x);
}

Aabb3d box_of(const Triangle3d& t) {
  Aabb3d box{t.a, t.a};
  for (double Point3d::*axis : coordinates) {
    const auto [least, greatest] = std::minmax({t.a.*axis, t.b.*axis, t.c.*axis}, [](double x, double y) {
      return kernel::ordered_bits(x) < kernel::ordered_bits(y);
    });
    box.min.*axis = least, box.max.*axis = greatest;
  }
  return box;
}

/// A face relative to another: its corners, and which of them the other uses too.
struct Seen {
  std::array<const Point3d*, 3> corners;
  std::array<bool, 3> common;

  Seen(const Meshd& mesh, const Face& f, const Face& other)
      : corners{&mesh.vertices[f.a], &mesh.vertices[f.b], &mesh.vertices[f.c]} {
    const auto has = [&other](Index v) { return v == other.a || v == other.b || v == other.c; };
    common = {has(f.a), has(f.b), has(f.c)};
  }
  int count() const { return static_cast<int>(std::count(common.begin(), common.end(), true)); }
};

/// True if s is below a plane perpendicular to the axis, or on it, and t above it or on it, and one of them has only
/// common corners on it. Their intersection is then spanned by those.
bool below(const Seen& s, const Seen& t, double Point3d::*axis) {
  const auto places = [axis](const Seen& face) {
    return std::array{kernel::ordered_bits((*face.corners[0]).*axis), kernel::ordered_bits((*face.corners[1]).*axis),
                      kernel::ordered_bits((*face.corners[2]).*axis)};
  };
  const auto of_s = places(s), of_t = places(t);
  const std::int64_t top = *std::max_element(of_s.begin(), of_s.end()),
                     bottom = *std::min_element(of_t.begin(), of_t.end());
  if (top != bottom) return top < bottom;
  const auto only_common = [top](const Seen& face, const auto& at) {
    bool only = true;
    for (std::size_t k = 0; k < 3; ++k) only &= face.common[k] || at[k] != top;
    return only;
  };
  return only_common(s, of_s) || only_common(t, of_t);
}

/// True if all corners of g except the common ones are on one side of the plane of f. side: that of a point, 0 on the
/// plane or unknown.
template <class Side>
bool beside(const Side& side_of, const Seen& g) {
  int side = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (g.common[k]) continue;
    const int here = side_of(*g.corners[k]);
    if (here == 0 || here == -side) return false;
    side = here;
  }
  return true;
}

/// True if, as seen along an axis along which f is no line, for certain all corners of g are beyond an edge of f,
/// except for common ones that are ends of that edge. Their intersection is then seen on that edge, so it is spanned by
/// common corners.
bool beyond_an_edge(const Seen& f, const Seen& g) {
  const auto& [a, b, c] = f.corners;
  const Vector3d normal = cross(*b - *a, *c - *a);  // an estimate
  const std::array sizes{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  const auto axis = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const auto seen = [u = coordinates[(axis + 1) % 3], v = coordinates[(axis + 2) % 3]](const Point3d* p) {
    return Point2d{p->*u, p->*v};
  };
  const filters::Sign inside = filters::orientation(seen(a), seen(b), seen(c));
  if (inside == filters::Sign::unknown) return false;
  const filters::Sign outside = inside == filters::Sign::positive ? filters::Sign::negative : filters::Sign::positive;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3d *const from = f.corners[k], *const to = f.corners[(k + 1) % 3];
    const auto beyond = [&](const Point3d* p) {
      return p == from || p == to || filters::orientation(seen(from), seen(to), seen(p)) == outside;
    };
    if (std::all_of(g.corners.begin(), g.corners.end(), beyond)) return true;
  }
  return false;
}

/// Two faces with areas contain the hull of their common vertices: nothing, a corner or an edge. They meet nowhere else
/// if their intersection has no greater dimension. Filters come first.
bool meet(const Meshd& mesh, const Face& f, const kernel::FaceSide& plane_of_f, const Face& g) {
  const Seen s(mesh, f, g), t(mesh, g, f);
  const int common = s.count();
  if (common == 3) return true;
  const kernel::FaceSide plane_of_g(mesh, g);
  const auto surely = [](const kernel::FaceSide& plane) {
    return [&plane](const Point3d& p) { return plane.surely(p); };
  };
  if (beside(surely(plane_of_f), t) || beside(surely(plane_of_g), s)) return false;
  for (double Point3d::*axis : coordinates)
    if (below(s, t, axis) || below(t, s, axis)) return false;
  if (beyond_an_edge(s, t) || beyond_an_edge(t, s)) return false;
  const auto exactly = [](const kernel::FaceSide& plane) {
    return [&plane](const Point3d& p) { return plane.of(p).answer; };
  };
  if (beside(exactly(plane_of_f), t) || beside(exactly(plane_of_g), s)) return false;
  return kernel::common_dimension(triangle_of(mesh, f), triangle_of(mesh, g)) >= common;
}

/// For each vertex of a closed oriented manifold of triangles whether it is known that the faces around it are a graph
/// over a coordinate plane: no two of them then meet but in the edge or the corner that they share.
///
/// Seen along an axis, the faces around a vertex follow one another as the edges there do. If all are seen from one
/// side, each takes an angle of less than half a turn, all in one direction; if they go around once, their angles have
/// nothing in common but the sides of neighbours, on which both have the whole edge. They go around as often as they
/// come from the lower half of the plane to the upper; twice that is the number of faces that have one edge in each
/// half. A half has one of its two borders, the right one with the upper half.
class Graphs {
 public:
  explicit Graphs(const Meshd& mesh) : sides_(mesh.vertices.size(), 0x3f), crossings_(mesh.vertices.size()) {
    const kernel::ControlWord guard;
    for (const Face& f : mesh.faces) {
      const std::uint8_t sides = certain_sides(triangle_of(mesh, f));
      for (const Index v : {f.a, f.b, f.c}) sides_[v] &= sides;
    }
    for (const Face& f : mesh.faces) {
      for (const auto& [v, p, q] : {std::array{f.a, f.b, f.c}, {f.b, f.c, f.a}, {f.c, f.a, f.b}}) {
        const auto axis = static_cast<std::size_t>(std::countr_zero(sides_[v])) / 2;
        if (axis >= 3 || crossings_[v] > 2) continue;
        double Point3d::*const right = coordinates[(axis + 1) % 3], Point3d::*const up = coordinates[(axis + 2) % 3];
        const auto above = [right, up, &from = mesh.vertices[v]](const Point3d& to) {
          return static_cast<int>(to.*up > from.*up) |
                 (static_cast<int>(to.*up == from.*up) & static_cast<int>(to.*right > from.*right));
        };
        crossings_[v] += static_cast<std::uint8_t>(above(mesh.vertices[p]) ^ above(mesh.vertices[q]));
      }
    }
  }

  /// True if both faces are of one such vertex.
  bool hold_apart(const Face& f, const Face& g) const {
    const auto common = [&](Index v) {
      return (v == g.a || v == g.b || v == g.c) && sides_[v] != 0 && crossings_[v] == 2;
    };
    return common(f.a) || common(f.b) || common(f.c);
  }

 private:
  /// Two bits for each axis: the corners are for certain counter-clockwise, clockwise as seen along it.
  static std::uint8_t certain_sides(const Triangle3d& t) {
    unsigned sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double Point3d::*const u = coordinates[(axis + 1) % 3], Point3d::*const v = coordinates[(axis + 2) % 3];
      const filters::Sign sign = filters::orientation(Point2d{t.a.*u, t.a.*v}, {t.b.*u, t.b.*v}, {t.c.*u, t.c.*v});
      sides |= static_cast<unsigned>(sign == filters::Sign::positive) << (2 * axis);
      sides |= static_cast<unsigned>(sign == filters::Sign::negative) << (2 * axis + 1);
    }
    return static_cast<std::uint8_t>(sides);
  }

  std::vector<std::uint8_t> sides_, crossings_;
};

/// The sides of triangles that are edges of their polygons; the others are diagonals.
class EdgesOfPolygons {
 public:
  EdgesOfPolygons(const Meshd& mesh, const std::vector<Index>& named) : mesh_(mesh), named_(named) {
    for (Index i = 0; i < mesh.polygons.size(); ++i) {
      const std::vector<Index>& corners = mesh.polygons[i];
      for (std::size_t k = 0; k < corners.size(); ++k)
        edges_.push_back(edge(i, corners[k], corners[(k + 1) % corners.size()]));
    }
    std::sort(edges_.begin(), edges_.end());
  }
  /// True if both triangles share two vertices between which one of the two polygons has no edge: that side runs
  /// through the inside of that polygon.
  bool share_a_diagonal(Index i, Index j) const {
    if (mesh_.polygons.empty()) return false;
    const Face &f = mesh_.faces[i], &g = mesh_.faces[j];
    const auto has = [&g](Index v) { return v == g.a || v == g.b || v == g.c; };
    for (const auto& [from, to] : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}})
      if (has(from) && has(to) && !(is_edge(named_[i], from, to) && is_edge(named_[j], from, to))) return true;
    return false;
  }

 private:
  using Edge = std::array<Index, 3>;
  static Edge edge(Index polygon, Index from, Index to) { return {polygon, std::min(from, to), std::max(from, to)}; }
  bool is_edge(Index polygon, Index from, Index to) const {
    return std::binary_search(edges_.begin(), edges_.end(), edge(polygon, from, to));
  }

  const Meshd& mesh_;
  const std::vector<Index>& named_;
  std::vector<Edge> edges_;
};

}  // namespace

std::optional<Index> first_flat_face(const Meshd& mesh) {
  for (Index i = 0; i < mesh.faces.size(); ++i)
    if (flat(triangle_of(mesh, mesh.faces[i]))) return named_face_of_each(mesh)[i];
  return std::nullopt;
}

std::optional<IndexPair> first_meeting_faces(const Meshd& mesh, bool surface) {
  std::vector<Aabb3d> boxes;
  boxes.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) boxes.push_back(box_of(triangle_of(mesh, face)));
  const std::vector<Index> named = named_face_of_each(mesh);
  const EdgesOfPolygons edges(mesh, named);
  std::optional<Graphs> graphs;
  if (surface && mesh.polygons.empty()) graphs.emplace(mesh);
  std::optional<IndexPair> first;
  std::optional<kernel::FaceSide> plane;
  Index of_plane = 0;
  look_at_near_faces(mesh, boxes, [&](Index i, Index j) {
    const IndexPair pair{named[i], named[j]};
    const bool before = !first || pair.i < first->i || (pair.i == first->i && pair.j < first->j);
    const Face &f = mesh.faces[i], &g = mesh.faces[j];
    if (pair.i == pair.j || !before || (graphs && graphs->hold_apart(f, g))) return;
    if (!plane || of_plane != i) plane.emplace(mesh, f), of_plane = i;
    if (meet(mesh, f, *plane, g) || edges.share_a_diagonal(i, j)) first = pair;
  });
  return first;
}

}  // namespace touchstone::robust::structures
