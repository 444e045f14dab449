// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

/// Rays, segments, boxes and balls in space; those of the plane are embedded at z = 0: their intersections stay the
/// same, and so do the names of fields.
namespace touchstone::robust::kernel {

/// The segment from + t (to - from), 0 <= t <= 1; or, if it does not end, the ray from + t to, t >= 0.
struct Line {
  Point3d from, to;
  bool ends;

  Line(const Ray3d& r) : from(r.origin), to{r.direction.x, r.direction.y, r.direction.z}, ends(false) {}
  Line(const Ray2d& r) : from{r.origin.x, r.origin.y, 0}, to{r.direction.x, r.direction.y, 0}, ends(false) {}
  Line(const Segment3d& s) : from(s.a), to(s.b), ends(true) {}
  Line(const Segment2d& s) : from{s.a.x, s.a.y, 0}, to{s.b.x, s.b.y, 0}, ends(true) {}

  Ray3d ray() const { return {from, {to.x, to.y, to.z}}; }
  Segment3d segment() const { return {from, to}; }
};

struct Box : Aabb3d {
  Box(const Aabb3d& box) : Aabb3d(box) {}
  Box(const Aabb2d& box) : Aabb3d{{box.min.x, box.min.y, 0}, {box.max.x, box.max.y, 0}} {}
};

struct Ball : Sphere3d {
  Ball(const Sphere3d& ball) : Sphere3d(ball) {}
  Ball(const Circle2d& disc) : Sphere3d{{disc.center.x, disc.center.y, 0}, disc.radius} {}
};

/// The passage of a line that misses a box or a ball.
inline const Passage<double> no_passage{PassageRelation::none, std::nullopt, std::nullopt};

}  // namespace touchstone::robust::kernel
