// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside of a polygon, on its `boundary` or outside: a ray from it crosses the edges an
/// odd number of times, it lies on an edge, or neither.
///
/// Any closed ring in either direction: it may cross or touch itself, repeat vertices, or lie on one line. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do fewer than 3 vertices. Contract: reference/polygons/point_in_polygon.h.
Location point_in_polygon(const Polygon2d& polygon, const Point2d& point);

class Polygon;  // robust/prepared/polygon.h
/// The same without its validation, by its tree.
Location point_in_polygon(const Polygon& polygon, const Point2d& point);

namespace stages {

/// The filter decides only points that are near to no line through an edge. After it, `ask` decides the ring part by
/// part and reports the latest stage that a part needed.
struct point_in_polygon : Signatures<Location(const Polygon2d&, const Point2d&)> {
  static Partial filter, lattice;
  static Total exact;
  static Staged ask;
  static Decided<Location> of_prepared(const Polygon& polygon, const Point2d& point);
};

}  // namespace stages

}  // namespace touchstone::robust
