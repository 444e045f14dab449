// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "catalogue/draw/drawing.h"
#include "geometry/points.h"
#include "geometry/space.h"

/// Views of space for drawings, rounded.
namespace touchstone::catalogue {

inline double largest(const Vector3d& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// v scaled so that its largest coordinate is 1, then to length 1; the zero vector unchanged.
inline Vector3d unit_of(const Vector3d& v) {
  const double size = largest(v);
  if (!(size > 0)) return v;
  const Vector3d w{v.x / size, v.y / size, v.z / size};
  const double length = std::sqrt(dot(w, w));
  return {w.x / length, w.y / length, w.z / length};
}

/// A plane seen from the side, as the line y = 0 with its front above.
struct SideView {
  Vector3d normal, across;  ///< of length 1; across lies in the plane, along the step as seen from above

  static SideView of(const Plane3d& plane, const Vector3d& step) {
    const Vector3d n = unit_of(plane.normal), v = unit_of(step);
    const double along = dot(v, n);
    return {n, unit_of({v.x - along * n.x, v.y - along * n.y, v.z - along * n.z})};
  }

  /// A position by its signed distance from the plane, which is more accurate than one from rounded coordinates.
  Point2d at(const Vector3d& from_start, double distance) const { return {dot(from_start, across), distance}; }

  /// Draws the plane as a line under that range, and its normal next to it.
  static void draw_plane(Drawing& drawing, double left, double right, double height) {
    const double size = std::max({right - left, std::fabs(height), std::ldexp(1, -1070)});
    drawing.figures.push_back({Figure::Kind::line, "plane", {left - size / 8, 0, right + size / 8, 0}, false});
    drawing.figures.push_back({Figure::Kind::arrow, "front", {left - size / 8, 0, left - size / 8, size / 4}, false});
  }
};

}  // namespace touchstone::catalogue
