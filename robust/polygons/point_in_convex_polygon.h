// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside of a convex polygon, on its `boundary` or outside.
///
/// The polygon may run in either direction and have flat vertices. Every call checks that it is convex. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do fewer than 3 vertices, and a polygon that is flat, not simple or not convex (with the
/// vertex). Contract: reference/polygons/point_in_convex_polygon.h.
Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point);

class ConvexPolygon;  // robust/prepared/polygon.h
/// The same without its validation, by its tree.
Location point_in_convex_polygon(const ConvexPolygon& polygon, const Point2d& point);

namespace stages {

/// The latest stage that one of its decisions needed.
struct point_in_convex_polygon : Signatures<Location(const Polygon2d&, const Point2d&)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
