// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "geometry/polyhedra.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"

/// Validation: what is valid input, written once for everybody. Each `validate` throws InvalidInput naming the field
/// and the rule, or returns. Numbers are looked at as bits, so this holds in every floating-point environment and build
/// type.
///
/// The order of rules is one for all operations (docs/judging.md): first the numbers of all fields, `validate_numbers`;
/// then the rules of each field, `validate`; then those that tie several fields.
namespace touchstone::validation {

inline bool finite(double value) { return (std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) != 0x7ff; }

/// -0.0 and 0.0 are zero; a subnormal is not, whatever the control word says. clang 17 and later would compile the last
/// line as value == 0.0, which is another question where subnormals are read as zero: the empty instruction hides from
/// it where the bits came from.
inline bool zero(double value) {
  auto bits = std::bit_cast<std::uint64_t>(value);
  __asm__("" : "+r"(bits));
  return bits << 1 == 0;
}
inline bool negative(double value) { return std::bit_cast<std::int64_t>(value) < 0 && !zero(value); }
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (zero(a) && zero(b));
}
/// Of numbers that are no doubles.
template <class Real>
bool same(const Real& a, const Real& b) {
  return a == b;
}
template <class Point>
bool same_position(const Point& p, const Point& q) {
  if constexpr (requires { p.z; }) {
    if (!same(p.z, q.z)) return false;
  }
  return same(p.x, q.x) && same(p.y, q.y);
}

inline void validate_numbers(const std::string& field, double value) {
  if (!finite(value)) throw InvalidInput(field, "finite number");
}
inline void validate_numbers(const std::string& field, const Point2d& p) {
  validate_numbers(field + "[0]", p.x), validate_numbers(field + "[1]", p.y);
}
inline void validate_numbers(const std::string& field, const Vector2d& v) {
  validate_numbers(field + "[0]", v.x), validate_numbers(field + "[1]", v.y);
}
inline void validate_numbers(const std::string& field, const Segment2d& s) {
  validate_numbers(field + "[0]", s.a), validate_numbers(field + "[1]", s.b);
}
inline void validate_numbers(const std::string& field, const Line2d& l) {
  validate_numbers(field + "[0]", l.p), validate_numbers(field + "[1]", l.q);
}
inline void validate_numbers(const std::string& field, const ParametricLine2d& l) {
  validate_numbers(field + ".origin", l.origin), validate_numbers(field + ".direction", l.direction);
}
inline void validate_numbers(const std::string& field, const Ray2d& r) {
  validate_numbers(field + ".origin", r.origin), validate_numbers(field + ".direction", r.direction);
}
inline void validate_numbers(const std::string& field, const Circle2d& c) {
  validate_numbers(field + ".center", c.center), validate_numbers(field + ".radius", c.radius);
}
inline void validate_numbers(const std::string& field, const Point3d& p) {
  validate_numbers(field + "[0]", p.x), validate_numbers(field + "[1]", p.y), validate_numbers(field + "[2]", p.z);
}
inline void validate_numbers(const std::string& field, const Vector3d& v) {
  validate_numbers(field + "[0]", v.x), validate_numbers(field + "[1]", v.y), validate_numbers(field + "[2]", v.z);
}
inline void validate_numbers(const std::string& field, const Plane3d& plane) {
  validate_numbers(field + ".normal", plane.normal), validate_numbers(field + ".offset", plane.offset);
}
inline void validate_numbers(const std::string& field, const Aabb2d& box) {
  validate_numbers(field + ".min", box.min), validate_numbers(field + ".max", box.max);
}
inline void validate_numbers(const std::string& field, const Aabb3d& box) {
  validate_numbers(field + ".min", box.min), validate_numbers(field + ".max", box.max);
}
inline void validate_numbers(const std::string& field, const Sphere3d& ball) {
  validate_numbers(field + ".center", ball.center), validate_numbers(field + ".radius", ball.radius);
}
inline void validate_numbers(const std::string& field, const Slabd& slab) {
  validate_numbers(field + "[0]", slab.min), validate_numbers(field + "[1]", slab.max);
}
template <class Shape>
void validate_numbers(const std::string& field, const std::vector<Shape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) validate_numbers(field + "[" + std::to_string(i) + "]", shapes[i]);
}
inline void validate_numbers(const std::string& field, const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  validate_numbers(field + ".center", box.center);
  validate_numbers(field + ".half_axes", std::vector<Vector3d>{u, v, w});
}
inline void validate_numbers(const std::string& field, const Kdop3d& kdop) {
  validate_numbers(field + ".normals", kdop.normals), validate_numbers(field + ".slabs", kdop.slabs);
}
/// Of many points a name is made for the one that is not finite alone.
template <class Point>
void validate_points_numbers(const std::string& field, const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    bool valid = finite(p.x) && finite(p.y);
    if constexpr (requires { p.z; }) valid = valid && finite(p.z);
    if (!valid) validate_numbers(field + "[" + std::to_string(i) + "]", p);
  }
}
inline void validate_numbers(const std::string& field, const Polygon2d& polygon) {
  validate_points_numbers(field, polygon.vertices);
}
inline void validate_numbers(const std::string& field, const Polygon3d& polygon) {
  validate_points_numbers(field, polygon.vertices);
}
inline void validate_numbers(const std::string& field, const Meshd& mesh) {
  validate_points_numbers(field + ".vertices", mesh.vertices);
}

/// Shapes that have no rules but that their numbers are finite.
inline void validate(const std::string& field, double value) { validate_numbers(field, value); }
inline void validate(const std::string& field, const Point2d& p) { validate_numbers(field, p); }
inline void validate(const std::string& field, const Segment2d& s) { validate_numbers(field, s); }
inline void validate(const std::string& field, const Point3d& p) { validate_numbers(field, p); }
inline void validate(const std::string& field, const Vector2d& v) { validate_numbers(field, v); }
inline void validate(const std::string& field, const Vector3d& v) { validate_numbers(field, v); }
/// But for the half axes' independence, which is decided where determinants are exact, and refused by refuse_dependent.
inline void validate(const std::string& field, const Obb3d& box) { validate_numbers(field, box); }

inline void validate(const std::string& field, const Line2d& l) {
  validate_numbers(field, l);
  if (same(l.p.x, l.q.x) && same(l.p.y, l.q.y)) throw InvalidInput(field, "two distinct points");
}
inline void validate_direction(const std::string& field, const Vector2d& v) {
  validate_numbers(field, v);
  if (zero(v.x) && zero(v.y)) throw InvalidInput(field, "nonzero direction");
}
inline void validate(const std::string& field, const ParametricLine2d& l) {
  validate_numbers(field, l), validate_direction(field + ".direction", l.direction);
}
inline void validate(const std::string& field, const Ray2d& r) {
  validate_numbers(field, r), validate_direction(field + ".direction", r.direction);
}
inline void validate(const std::string& field, const Circle2d& c) {
  validate_numbers(field, c);
  if (negative(c.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}
inline void validate_normal(const std::string& field, const Vector3d& normal) {
  validate_numbers(field, normal);
  if (zero(normal.x) && zero(normal.y) && zero(normal.z)) throw InvalidInput(field, "nonzero normal");
}
inline void validate(const std::string& field, const Plane3d& plane) {
  validate_numbers(field, plane), validate_normal(field + ".normal", plane.normal);
}

/// min <= max, of finite numbers as bits: in every floating-point environment.
inline bool in_order(double min, double max) {
  const auto key = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  return key(min) <= key(max);
}
inline void validate(const std::string& field, const Aabb2d& box) {
  validate_numbers(field, box);
  if (!in_order(box.min.x, box.max.x)) throw InvalidInput(field + ".max[0]", "min <= max");
  if (!in_order(box.min.y, box.max.y)) throw InvalidInput(field + ".max[1]", "min <= max");
}
inline void validate(const std::string& field, const Aabb3d& box) {
  validate_numbers(field, box);
  if (!in_order(box.min.x, box.max.x)) throw InvalidInput(field + ".max[0]", "min <= max");
  if (!in_order(box.min.y, box.max.y)) throw InvalidInput(field + ".max[1]", "min <= max");
  if (!in_order(box.min.z, box.max.z)) throw InvalidInput(field + ".max[2]", "min <= max");
}
inline void validate(const std::string& field, const Sphere3d& ball) {
  validate_numbers(field, ball);
  if (negative(ball.radius)) throw InvalidInput(field + ".radius", "radius >= 0");
}
[[noreturn]] inline void refuse_dependent(const std::string& field) {
  throw InvalidInput(field + ".half_axes", "linearly independent");
}
inline void validate(const std::string& field, const Slabd& slab) {
  validate_numbers(field, slab);
  if (!in_order(slab.min, slab.max)) throw InvalidInput(field + "[1]", "min <= max");
}
/// The lengths of its lists.
template <class Real>
void validate_lengths(const std::string& field, const Kdop3<Real>& kdop) {
  if (kdop.normals.empty()) throw InvalidInput(field + ".normals", "at least 1 normal");
  if (kdop.slabs.size() != kdop.normals.size()) throw InvalidInput(field + ".slabs", "as many slabs as normals");
}
inline void validate(const std::string& field, const Kdop3d& kdop) {
  validate_numbers(field, kdop), validate_lengths(field, kdop);
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    validate_normal(field + ".normals[" + std::to_string(i) + "]", kdop.normals[i]);
    validate(field + ".slabs[" + std::to_string(i) + "]", kdop.slabs[i]);
  }
}
/// Points around which something is built.
template <class Point>
void validate_points(const std::string& field, const std::vector<Point>& points) {
  validate_points_numbers(field, points);
  if (points.empty()) throw InvalidInput(field, "at least 1 point");
}

template <class Shape>
void validate(const std::string& field, const std::vector<Shape>& shapes) {
  validate_numbers(field, shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i) validate(field + "[" + std::to_string(i) + "]", shapes[i]);
}

/// Whether the last position of a ring repeats the first, as GeoJSON, WKT and editors write rings. Such a position is
/// no vertex: it is dropped, once, so that every other keeps its index. -0.0 equals 0.0.
template <class Point>
bool closed(const std::vector<Point>& ring) {
  return ring.size() > 1 && same_position(ring.front(), ring.back());
}
template <class Point>
bool fewer_than_three(const std::vector<Point>& ring) {
  return ring.size() < 3 || (ring.size() == 3 && closed(ring));
}

/// A polygon without the position that closes it; it has to outlive this.
template <class Polygon>
class OpenRing {
 public:
  explicit OpenRing(const Polygon& given) : given_(given) {
    if (closed(given.vertices)) dropped_ = {{given.vertices.begin(), given.vertices.end() - 1}};
  }
  const Polygon& operator*() const { return dropped_.vertices.empty() ? given_ : dropped_; }

 private:
  const Polygon& given_;
  Polygon dropped_;
};

template <class Point>
void validate_ring(const std::string& field, const std::vector<Point>& vertices) {
  validate_points_numbers(field, vertices);
  if (fewer_than_three(vertices)) throw InvalidInput(field, "at least 3 vertices");
}
/// Why a ring is not simple: edge `first` has length zero (and `second` is the same), or meets edge `second` > first
/// elsewhere than in a vertex that neighbours share. Edge i goes from vertex i to the next. Of several defects the one
/// with the least `first` counts, edges of length zero before all others, then the least `second`.
struct RingDefect {
  std::size_t first, second;
};

/// Of a ring of so many vertices.
[[noreturn]] inline void refuse(const std::string& field, const RingDefect& defect, std::size_t vertices) {
  const std::string vertex = field + "[" + std::to_string(defect.first) + "]";
  const std::string next = std::to_string((defect.first + 1) % vertices);
  if (defect.first == defect.second)
    throw InvalidInput(vertex, "different from vertex " + next + ": drop one of the two");
  throw InvalidInput(vertex, "simple: its edge must not meet edge " + std::to_string(defect.second));
}

/// Why a polygon is not convex, in this order: an edge of length zero; all vertices on one line; a RingDefect; the
/// first vertex at which the ring turns against its direction.
[[noreturn]] inline void refuse_flat(const std::string& field) {
  throw InvalidInput(field, "convex: vertices on one line have no inside");
}
[[noreturn]] inline void refuse_reflex(const std::string& field, std::size_t vertex) {
  throw InvalidInput(field + "[" + std::to_string(vertex) + "]",
                     "convex: the ring must not turn against its direction");
}

inline void validate(const std::string& field, const Polygon2d& polygon) { validate_ring(field, polygon.vertices); }
inline void validate(const std::string& field, const Polygon3d& polygon) { validate_ring(field, polygon.vertices); }

/// A mesh named by polygons, in this order: a corner names no vertex; the triangles are not as many as a cut of them
/// has; the corners of a face are not in one plane; the triangles of a face do not cut it.
[[noreturn]] inline void refuse_cut(const std::string& field) {
  throw InvalidInput(field + ".cut", "a cut of the faces into triangles");
}
[[noreturn]] inline void refuse_askew(const std::string& field, std::size_t polygon) {
  throw InvalidInput(field + ".faces[" + std::to_string(polygon) + "]", "planar");
}

[[noreturn]] inline void refuse_ring(const std::string& field, std::size_t polygon) {
  throw InvalidInput(field + ".faces[" + std::to_string(polygon) + "]",
                     "a polygon that encloses one area and does not cross itself");
}

/// Each of the corners names a vertex that is there.
template <class Real, class Corners>
void validate_corners(const std::string& field, const Mesh<Real>& mesh, const Corners& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k] < mesh.vertices.size()) continue;
    throw InvalidInput(field + "[" + std::to_string(k) + "]", "index of a vertex");
  }
}
/// The corners of polygons.
template <class Real>
void validate_corners(const std::string& field, const Mesh<Real>& mesh) {
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const std::string face = field + ".faces[" + std::to_string(i) + "]";
    if (mesh.polygons[i].size() < 3) throw InvalidInput(face, "at least 3 corners");
    validate_corners(face, mesh, mesh.polygons[i]);
  }
}
/// Every face of a mesh names vertices that are there, and there are as many triangles as a cut of polygons has.
template <class Real>
void validate_indices(const std::string& field, const Mesh<Real>& mesh) {
  validate_corners(field, mesh);
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const std::array<Index, 3> corners{mesh.faces[i].a, mesh.faces[i].b, mesh.faces[i].c};
    if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return v < mesh.vertices.size(); })) continue;
    validate_corners(field + (mesh.polygons.empty() ? ".faces[" : ".cut[") + std::to_string(i) + "]", mesh, corners);
  }
  std::size_t triangles = 0;
  for (const auto& polygon : mesh.polygons) triangles += polygon.size() - 2;
  if (!mesh.polygons.empty() && triangles != mesh.faces.size()) refuse_cut(field);
}
inline void validate(const std::string& field, const Meshd& mesh) {
  validate_numbers(field, mesh), validate_indices(field, mesh);
}

/// The face of which that triangle is a part.
template <class Real>
[[noreturn]] void refuse_face(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle,
                              const std::string& rule) {
  throw InvalidInput(field + ".faces[" + std::to_string(named_face_of_each(mesh)[triangle]) + "]", rule);
}

/// What every surface of triangles around a solid needs before anything is measured.
template <class Real>
void validate_triangles(const std::string& field, const Mesh<Real>& mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    if (f.a == f.b || f.b == f.c || f.c == f.a) refuse_face(field, mesh, i, "three different vertices");
  }
  if (named_faces(mesh) < 4) throw InvalidInput(field, "at least 4 faces");
}

/// Why a mesh is no closed convex surface, in this order: an edge of a face that another face has in the same direction
/// or that none has in the opposite one; a face of area zero; all vertices on one plane; a vertex beyond the plane of a
/// face. Of several the first face counts, in it the first edge (a to b, b to c, c to a) or the first vertex.
template <class Real>
[[noreturn]] void refuse_edge(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle, Index from,
                              Index to) {
  const std::string a = std::to_string(from), b = std::to_string(to);
  refuse_face(field, mesh, triangle,
              "closed: edge " + a + " -> " + b + " must occur once, and " + b + " -> " + a + " once");
}
template <class Real>
[[noreturn]] void refuse_area(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle) {
  refuse_face(field, mesh, triangle, "nonzero area");
}
[[noreturn]] inline void refuse_flat_mesh(const std::string& field) {
  throw InvalidInput(field, "convex: vertices on one plane have no inside");
}
template <class Real>
[[noreturn]] void refuse_beyond(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle,
                                std::size_t vertex) {
  refuse_face(field, mesh, triangle, "convex: vertex " + std::to_string(vertex) + " must not lie beyond its plane");
}

}  // namespace touchstone::validation
