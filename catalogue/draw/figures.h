// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "catalogue/codec/json.h"
#include "catalogue/draw/drawing.h"
#include "geometry/capsules.h"
#include "geometry/polygons.h"
#include "geometry/polyhedra.h"
#include "geometry/rays.h"
#include "geometry/penetration.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"

/// The drawing of each shape, for rows that draw more than their arguments; by_shape.cpp draws a new shape.
namespace touchstone::catalogue {

inline void draw(Drawing& drawing, const std::string& label, double value, bool) {
  drawing.notes.push_back(label + " = " + decimal(value));
}
inline void draw(Drawing& drawing, const std::string& label, const Point2d& p, bool answer) {
  drawing.figures.push_back({Figure::Kind::point, label, {p.x, p.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const Vector2d& v, bool answer) {
  drawing.figures.push_back({Figure::Kind::arrow, label, {0, 0, v.x, v.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const Segment2d& s, bool answer) {
  drawing.figures.push_back({Figure::Kind::segment, label, {s.a.x, s.a.y, s.b.x, s.b.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const Line2d& l, bool answer) {
  drawing.figures.push_back({Figure::Kind::line, label, {l.p.x, l.p.y, l.q.x, l.q.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const ParametricLine2d& l, bool answer) {
  const Point2d end = l.origin + l.direction;
  drawing.figures.push_back({Figure::Kind::line, label, {l.origin.x, l.origin.y, end.x, end.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const Ray2d& r, bool answer) {
  const Point2d end = r.origin + r.direction;
  drawing.figures.push_back({Figure::Kind::ray, label, {r.origin.x, r.origin.y, end.x, end.y}, answer});
}
inline void draw(Drawing& drawing, const std::string& label, const Polygon2d& polygon, bool answer) {
  Figure figure{Figure::Kind::polygon, label, {}, answer};
  for (const Point2d& p : polygon.vertices) figure.numbers.insert(figure.numbers.end(), {p.x, p.y});
  drawing.figures.push_back(std::move(figure));
}
/// Its rings; holes are named by their place.
inline void draw(Drawing& drawing, const std::string& label, const Region2d& region, bool answer) {
  draw(drawing, label, region.outer, answer);
  for (std::size_t i = 0; i < region.holes.size(); ++i)
    draw(drawing, label + ".holes[" + std::to_string(i) + "]", region.holes[i], answer);
}
inline void draw(Drawing& drawing, const std::string& label, const Circle2d& c, bool answer) {
  drawing.figures.push_back({Figure::Kind::circle, label, {c.center.x, c.center.y, c.radius}, answer});
}

inline void draw(Drawing& drawing, const std::string& label, const Aabb2d& box, bool answer) {
  drawing.figures.push_back({Figure::Kind::polygon,
                             label,
                             {box.min.x, box.min.y, box.max.x, box.min.y, box.max.x, box.max.y, box.min.x, box.max.y},
                             answer});
}

/// Numbers one after the other, as a figure in space takes them.
inline std::vector<double> coordinates_of(const std::vector<Point3d>& points) {
  std::vector<double> numbers;
  for (const Point3d& p : points) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  return numbers;
}
inline std::string in_words(const Point3d& p) {
  return "(" + decimal(p.x) + ", " + decimal(p.y) + ", " + decimal(p.z) + ")";
}

/// Values that a view of space cannot show to the last digit are also noted in words.
inline void draw(Drawing& drawing, const std::string& label, const Point3d& p, bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::point, label, {p.x, p.y, p.z}, {}, answer});
  drawing.notes.push_back(label + ": " + in_words(p));
}
/// A vector that belongs to a position, which its row knows.
inline void draw_from(Drawing& drawing, const std::string& label, const Point3d& start, const Vector3d& v,
                      bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::arrow, label, coordinates_of({start, start + v}), {}, answer});
  drawing.notes.push_back(label + ": " + in_words({v.x, v.y, v.z}));
}
inline void draw(Drawing& drawing, const std::string& label, const Vector3d& v, bool answer) {
  draw_from(drawing, label, {0, 0, 0}, v, answer);
}
inline void draw(Drawing& drawing, const std::string& label, const Plane3d& plane, bool answer) {
  const Vector3d& n = plane.normal;
  drawing.space.push_back({SpaceFigure::Kind::plane, label, {n.x, n.y, n.z, plane.offset}, {}, answer});
  drawing.notes.push_back(label + ": normal " + in_words({n.x, n.y, n.z}) + ", offset " + decimal(plane.offset));
}
inline void draw(Drawing& drawing, const std::string& label, const Polygon3d& polygon, bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::polygon, label, coordinates_of(polygon.vertices), {}, answer});
}
/// Drawn as polygons of two corners and of three.
inline void draw(Drawing& drawing, const std::string& label, const Segment3d& s, bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::polygon, label, coordinates_of({s.a, s.b}), {}, answer});
  drawing.notes.push_back(label + ": " + in_words(s.a) + " to " + in_words(s.b));
}
inline void draw(Drawing& drawing, const std::string& label, const Triangle3d& t, bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::polygon, label, coordinates_of({t.a, t.b, t.c}), {}, answer});
  drawing.notes.push_back(label + ": " + in_words(t.a) + ", " + in_words(t.b) + ", " + in_words(t.c));
}
/// An arrow of the length of its direction.
inline void draw(Drawing& drawing, const std::string& label, const Ray3d& ray, bool answer) {
  const auto& [origin, v] = ray;
  drawing.space.push_back({SpaceFigure::Kind::arrow, label, coordinates_of({origin, origin + v}), {}, answer});
  drawing.notes.push_back(label + ": from " + in_words(origin) + " along " + in_words({v.x, v.y, v.z}));
}
inline void draw(Drawing& drawing, const std::string& label, const Aabb3d& box, bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::box, label, coordinates_of({box.min, box.max}), {}, answer});
  drawing.notes.push_back(label + ": " + in_words(box.min) + " to " + in_words(box.max));
}
inline void draw(Drawing& drawing, const std::string& label, const Sphere3d& s, bool answer) {
  drawing.space.push_back(
      {SpaceFigure::Kind::sphere, label, {s.center.x, s.center.y, s.center.z, s.radius}, {}, answer});
  drawing.notes.push_back(label + ": center " + in_words(s.center) + ", radius " + decimal(s.radius));
}
/// Draws the segment, and a ball at each of its ends.
inline void draw(Drawing& drawing, const std::string& label, const Capsule3d& capsule, bool answer) {
  const auto& [segment, radius] = capsule;
  draw(drawing, label, segment, answer);
  for (const Point3d& p : {segment.a, segment.b})
    drawing.space.push_back({SpaceFigure::Kind::sphere, label, {p.x, p.y, p.z, radius}, {}, answer});
  drawing.notes.push_back(label + ": radius " + decimal(radius));
}
/// A mesh without faces stands for a point, a segment or a triangle, where an operation takes it.
inline void draw(Drawing& drawing, const std::string& label, const Meshd& mesh, bool answer) {
  if (is_simplex(mesh)) {
    const auto& p = mesh.vertices;
    if (p.size() == 1) draw(drawing, label, p[0], answer);
    else if (p.size() == 2) draw(drawing, label, Segment3d{p[0], p[1]}, answer);
    else draw(drawing, label, Triangle3d{p[0], p[1], p[2]}, answer);
    return;
  }
  SpaceFigure figure{SpaceFigure::Kind::mesh, label, coordinates_of(mesh.vertices), {}, answer};
  for (const Face& face : mesh.faces) figure.faces.push_back({face.a, face.b, face.c});
  drawing.space.push_back(std::move(figure));
}
/// A parallelepiped by its eight corners.
inline void draw(Drawing& drawing, const std::string& label, const Obb3d& box, bool answer) {
  const auto& [u, v, w] = box.half_axes;
  std::vector<Point3d> corners;
  for (const double r : {-1.0, 1.0})
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0}) corners.push_back(box.center + (r * u + (s * v + t * w)));
  SpaceFigure figure{SpaceFigure::Kind::mesh, label, coordinates_of(corners), {}, answer};
  figure.faces = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  const double volume = dot(cross(u, v), w);
  if (volume < 0)
    for (auto& face : figure.faces) std::reverse(face.begin(), face.end());
  drawing.space.push_back(std::move(figure));
  drawing.notes.push_back(label + ": center " + in_words(box.center) + ", half axes " + in_words({u.x, u.y, u.z}) +
                          ", " + in_words({v.x, v.y, v.z}) + ", " + in_words({w.x, w.y, w.z}));
}
inline void draw(Drawing& drawing, const std::string& label, const Slabd& slab, bool) {
  drawing.notes.push_back(label + ": from " + decimal(slab.min) + " to " + decimal(slab.max));
}

/// The elements of a list, numbered; the input already contains their numbers, unless they are all there is to show.
template <class T>
requires requires(Drawing& drawing, const T& element) { draw(drawing, std::string(), element, false); }
void draw(Drawing& drawing, const std::string& label, const std::vector<T>& list, bool answer) {
  const std::vector<std::string> notes = drawing.notes;
  for (std::size_t i = 0; i < list.size(); ++i) draw(drawing, label + "[" + std::to_string(i) + "]", list[i], answer);
  if constexpr (!std::is_arithmetic_v<T>) drawing.notes = notes;
  if (list.empty()) drawing.notes.push_back(label + ": none");
}

}  // namespace touchstone::catalogue
