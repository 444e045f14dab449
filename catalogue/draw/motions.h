// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/draw/figures.h"
#include "catalogue/draw/side_view.h"
#include "geometry/bodies.h"
#include "geometry/capsules.h"

/// Moving bodies: their positions, their destinations, and their first contact. Drawings are rounded.
namespace touchstone::catalogue {

inline Aabb2d moved(const Aabb2d& box, const Vector2d& v) { return {box.min + v, box.max + v}; }
inline Aabb3d moved(const Aabb3d& box, const Vector3d& v) { return {box.min + v, box.max + v}; }
inline Sphere3d moved(const Sphere3d& s, const Vector3d& v) { return {s.center + v, s.radius}; }
inline Capsule3d moved(const Capsule3d& c, const Vector3d& v) { return {{c.segment.a + v, c.segment.b + v}, c.radius}; }
inline Obb3d moved(const Obb3d& box, const Vector3d& v) { return {box.center + v, box.half_axes}; }
inline Meshd moved(Meshd mesh, const Vector3d& v) {
  for (Point3d& p : mesh.vertices) p = p + v;
  return mesh;
}

/// The points whose paths outline the swept volume.
inline std::vector<Point2d> outline(const Aabb2d& box, const Vector2d&) {
  return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}
inline std::vector<Point3d> outline(const Aabb3d& box, const Vector3d&) {
  std::vector<Point3d> corners;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) corners.push_back({x, y, z});
  return corners;
}
inline std::vector<Point3d> outline(const Obb3d& box, const Vector3d&) {
  std::vector<Point3d> corners;
  const auto& [u, v, w] = box.half_axes;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) corners.push_back(box.center + (x * u + y * v + z * w));
  return corners;
}
inline std::vector<Point3d> outline(const Meshd& mesh, const Vector3d&) {
  constexpr std::size_t most = 24;
  return mesh.vertices.size() <= most ? mesh.vertices : std::vector<Point3d>{};
}
/// Four points of the ball's great circle perpendicular to the displacement.
inline std::vector<Point3d> outline(const Sphere3d& s, const Vector3d& v) {
  const Vector3d displacement = unit_of(v);
  const bool along_x = std::fabs(displacement.x) > 0.5;
  const Vector3d one = unit_of(cross(displacement, along_x ? Vector3d{0, 1, 0} : Vector3d{1, 0, 0})),
                 other = cross(displacement, one);
  return {s.center + s.radius * one, s.center + -s.radius * one, s.center + s.radius * other,
          s.center + -s.radius * other};
}
/// Those of the balls around both ends.
inline std::vector<Point3d> outline(const Capsule3d& c, const Vector3d& v) {
  std::vector<Point3d> points = outline(Sphere3d{c.segment.a, c.radius}, v);
  for (const Point3d& p : outline(Sphere3d{c.segment.b, c.radius}, v)) points.push_back(p);
  return points;
}

inline Point2d middle_of(const Aabb2d& box) { return {box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2}; }
inline Point3d middle_of(const Aabb3d& box) {
  return {box.min.x / 2 + box.max.x / 2, box.min.y / 2 + box.max.y / 2, box.min.z / 2 + box.max.z / 2};
}
inline Point3d middle_of(const Obb3d& box) { return box.center; }
inline Point3d middle_of(const Sphere3d& s) { return s.center; }
inline Point3d middle_of(const Capsule3d& c) { return middle_of(Aabb3d{c.segment.a, c.segment.b}); }
inline Point3d middle_of(const Meshd& mesh) {
  Vector3d sum{0, 0, 0};
  const double part = 1 / static_cast<double>(mesh.vertices.size());
  for (const Point3d& p : mesh.vertices) sum = sum + part * Vector3d{p.x, p.y, p.z};
  return {sum.x, sum.y, sum.z};
}

inline void draw_arrow(Drawing& drawing, const std::string& label, const Point2d& from, const Vector2d& v,
                       bool answer) {
  const Point2d to = from + v;
  drawing.figures.push_back({Figure::Kind::arrow, label, {from.x, from.y, to.x, to.y}, answer});
}
inline void draw_arrow(Drawing& drawing, const std::string& label, const Point3d& from, const Vector3d& v,
                       bool answer) {
  drawing.space.push_back({SpaceFigure::Kind::arrow, label, coordinates_of({from, from + v}), {}, answer});
}
inline void draw_displacement(Drawing& drawing, const Point2d& from, const Point2d& to) {
  drawing.figures.push_back({Figure::Kind::segment, "", {from.x, from.y, to.x, to.y}, false});
}
inline void draw_displacement(Drawing& drawing, const Point3d& from, const Point3d& to) {
  drawing.space.push_back({SpaceFigure::Kind::segment, "", coordinates_of({from, to}), {}, false});
}

inline bool is_zero(const Vector2d& v) { return v.x == 0 && v.y == 0; }
inline bool is_zero(const Vector3d& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// Makes the last figure in space move: with one velocity before t = 0 and with another after it.
inline void let_move(Drawing& drawing, const Vector3d& before, const Vector3d& after) {
  drawing.space.back().moves = {{-before.x, -before.y, -before.z}, {after.x, after.y, after.z}};
}
inline void let_move_from_start(Drawing& drawing, const Vector3d& v) { let_move(drawing, {0, 0, 0}, v); }
inline void let_move_from_start(Drawing&, const Vector2d&) {}

/// Draws a body at the start of a step, its velocity, and, thinner, its position at the end and the volume between. If
/// the bodies meet at t, also its position then, which belongs to the answer.
template <class Solid, class Vector>
void draw_sweep(Drawing& drawing, const std::string& name, const Solid& solid, const Vector& velocity,
                const std::optional<double>& t) {
  draw(drawing, name, solid, false);
  if (is_zero(velocity)) return;
  let_move_from_start(drawing, velocity);
  draw_arrow(drawing, "velocity of " + name, middle_of(solid), velocity, false);
  const std::vector<std::string> notes = drawing.notes;
  draw(drawing, "", moved(solid, velocity), false);
  for (const auto& p : outline(solid, velocity)) draw_displacement(drawing, p, p + velocity);
  if (t && std::isfinite(*t)) draw(drawing, name + " at first contact", moved(solid, *t * velocity), true);
  drawing.notes = notes;
}

/// The same of a question: a body, its velocity and what rests.
template <class Question>
void draw_step(Drawing& drawing, const char* moving, const char* resting, const Question& question,
               const std::optional<double>& t) {
  const auto& [body, velocity, obstacle] = question;
  draw_sweep(drawing, moving, body, velocity, t);
  draw(drawing, resting, obstacle, false);
}

/// Two balls that represent bodies without given positions: they touch at the origin and approach along the normal, a
/// on the side from which it comes.
struct TouchingBalls {
  Point3d a, b;
  double radius;
  static TouchingBalls of(const Velocitiesd& v, const Vector3d& normal) {
    const double fastest = std::max(largest(v.first), largest(v.second)), radius = fastest > 0 ? fastest / 3 : 1;
    const Vector3d n = unit_of(normal);
    const bool comes_along = dot(n, unit_of(v.first - v.second)) > 0;
    const Vector3d reach = (comes_along ? -radius : radius) * n;
    return {Point3d{0, 0, 0} + reach, Point3d{0, 0, 0} + (-1.0 * reach), radius};
  }
  /// The velocities before, from the bodies.
  void draw_before(Drawing& drawing, const Velocitiesd& v) const {
    drawing.space.push_back({SpaceFigure::Kind::sphere, "a", {a.x, a.y, a.z, radius}, {}, false});
    let_move(drawing, v.first, v.first);
    draw_arrow(drawing, "a before", a, v.first, false);
    drawing.space.push_back({SpaceFigure::Kind::sphere, "b", {b.x, b.y, b.z, radius}, {}, false});
    let_move(drawing, v.second, v.second);
    draw_arrow(drawing, "b before", b, v.second, false);
    drawing.notes.push_back("before: a " + in_words({v.first.x, v.first.y, v.first.z}) + ", b " +
                            in_words({v.second.x, v.second.y, v.second.z}));
  }
  /// The same, and the normal at the contact.
  void draw_before(Drawing& drawing, const Velocitiesd& v, const Vector3d& normal) const {
    draw_before(drawing, v);
    draw_arrow(drawing, "normal", {0, 0, 0}, radius * unit_of(normal), false);
    drawing.notes.back() += ", normal " + in_words({normal.x, normal.y, normal.z});
  }
  void draw_after(Drawing& drawing, const Velocitiesd& v) const {
    for (SpaceFigure& figure : drawing.space) {
      const Vector3d& after = figure.label == "a" ? v.first : v.second;
      if (figure.moves) figure.moves->at_1 = {after.x, after.y, after.z};
    }
    draw_arrow(drawing, "a after", a, v.first, true);
    draw_arrow(drawing, "b after", b, v.second, true);
  }
};

/// The velocity of a body before and after it bounces off a plane: the body is at the origin, where it meets the plane.
/// The velocity before ends there, and the one after starts there. Both are also given in numbers.
inline void draw_bounce(Drawing& drawing, const Vector3d& before, const Vector3d& normal, const Vector3d& after) {
  const Point3d body{0, 0, 0};
  drawing.space.push_back({SpaceFigure::Kind::point, "body", coordinates_of({body}), {}, false});
  let_move(drawing, before, after);
  if (!is_zero(normal))
    drawing.space.push_back({SpaceFigure::Kind::plane, "plane", {normal.x, normal.y, normal.z, 0}, {}, false});
  if (!is_zero(before)) draw_arrow(drawing, "before", body + -1.0 * before, before, false);
  if (!is_zero(after)) draw_arrow(drawing, "after", body, after, true);
  drawing.notes.push_back("before: " + in_words({before.x, before.y, before.z}) + ", normal " +
                          in_words({normal.x, normal.y, normal.z}));
}

/// Bodies in a row with their velocities, since the question has no positions.
inline void draw_in_a_row(Drawing& drawing, const std::vector<Bodyd>& bodies) {
  double fastest = 0;
  for (const Bodyd& body : bodies) fastest = std::max(fastest, largest(body.velocity));
  const double apart = fastest > 0 ? 2 * fastest : 2;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Point3d at{apart * static_cast<double>(i), 0, 0};
    drawing.space.push_back({SpaceFigure::Kind::point, std::to_string(i), coordinates_of({at}), {}, false});
    if (!is_zero(bodies[i].velocity))
      draw_arrow(drawing, "velocity of " + std::to_string(i), at, bodies[i].velocity, false);
  }
  drawing.notes.push_back("the question has no places: the bodies are drawn in a row");
}

/// The contribution of each body to the momentum, head to tail from the origin; the sum leads to the last head.
inline void draw_head_to_tail(Drawing& drawing, const std::vector<Bodyd>& bodies, const Vector3d& momentum) {
  Point3d tail{0, 0, 0};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vector3d part = bodies[i].mass * bodies[i].velocity;
    draw_arrow(drawing, "momentum of " + std::to_string(i), tail, part, false);
    tail = tail + part;
  }
  draw_arrow(drawing, "sum", {0, 0, 0}, momentum, true);
  drawing.notes.push_back("mass times velocity of each body, head to tail");
}

inline void draw_masses(Drawing& drawing, const Massesd& masses) {
  drawing.notes.push_back("masses " + decimal(masses.first) + " and " + decimal(masses.second) +
                          "; the question has no places: balls of one size are drawn where they touch");
}

}  // namespace touchstone::catalogue
