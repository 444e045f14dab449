// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"
#include "catalogue/scene.h"
#include "geometry/polygons.h"
#include "geometry/space.h"
#include "geometry/thin_shapes.h"

/// How each shape is drawn; a new type of geometry adds its overload.
namespace touchstone::audit {

inline void draw(Scene& scene, const std::string& label, double value, bool) {
  scene.notes.push_back(label + " = " + decimal(value));
}
inline void draw(Scene& scene, const std::string& label, const Point2d& p, bool answer) {
  scene.figures.push_back({Figure::Kind::point, label, {p.x, p.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const Vector2d& v, bool answer) {
  scene.figures.push_back({Figure::Kind::arrow, label, {0, 0, v.x, v.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const Segment2d& s, bool answer) {
  scene.figures.push_back({Figure::Kind::segment, label, {s.a.x, s.a.y, s.b.x, s.b.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const Line2d& l, bool answer) {
  scene.figures.push_back({Figure::Kind::line, label, {l.p.x, l.p.y, l.q.x, l.q.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const ParametricLine2d& l, bool answer) {
  const Point2d end = l.origin + l.direction;
  scene.figures.push_back({Figure::Kind::line, label, {l.origin.x, l.origin.y, end.x, end.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const Ray2d& r, bool answer) {
  const Point2d end = r.origin + r.direction;
  scene.figures.push_back({Figure::Kind::ray, label, {r.origin.x, r.origin.y, end.x, end.y}, answer});
}
inline void draw(Scene& scene, const std::string& label, const Polygon2d& polygon, bool answer) {
  Figure figure{Figure::Kind::polygon, label, {}, answer};
  for (const Point2d& p : polygon.vertices) figure.numbers.insert(figure.numbers.end(), {p.x, p.y});
  scene.figures.push_back(std::move(figure));
}
inline void draw(Scene& scene, const std::string& label, const Circle2d& c, bool answer) {
  scene.figures.push_back({Figure::Kind::circle, label, {c.center.x, c.center.y, c.radius}, answer});
}

/// Positions and vectors of space are told; which view shows them, each row knows (space_figures.h).
inline void draw(Scene& scene, const std::string& label, const Point3d& p, bool) {
  scene.notes.push_back(label + ": (" + decimal(p.x) + ", " + decimal(p.y) + ", " + decimal(p.z) + ")");
}
inline void draw(Scene& scene, const std::string& label, const Vector3d& v, bool answer) {
  draw(scene, label, Point3d{v.x, v.y, v.z}, answer);
}

}  // namespace touchstone::audit
