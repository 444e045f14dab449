// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two simple polygons, as closed solids, are `disjoint`, only touch or overlap.
///
/// `overlapping`: they have a common interior point, even if one lies within the other. `touching`: their intersection
/// lies on both boundaries. Either orientation. Right for all finite doubles in every floating-point environment. NaN
/// and infinities throw InvalidInput, which names the field and "finite number"; so do fewer than 3 vertices and a
/// polygon that is not simple (with the vertex). Contract: reference/polygons/polygon_polygon.h.
Contact polygon_polygon(const Polygon2d& a, const Polygon2d& b);

class SimplePolygon;  // robust/prepared/polygon.h
/// The same without its validation.
Contact polygon_polygon(const SimplePolygon& a, const SimplePolygon& b);

namespace stages {

/// The latest stage that one of its decisions needed.
struct polygon_polygon : Signatures<Contact(const Polygon2d&, const Polygon2d&)> {
  static Staged ask;
  static Decided<Contact> of_prepared(const SimplePolygon& a, const SimplePolygon& b);
};

}  // namespace stages

}  // namespace touchstone::robust
