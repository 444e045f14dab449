// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a point lies inside a region, a polygon with holes, on its `boundary` (an edge of any of its rings)
/// or outside.
///
/// Rings in either direction; a last position that repeats the first is dropped. Right for all finite doubles in every
/// floating-point environment. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do
/// a ring of fewer than 3 vertices or one that is not simple, a hole that is not inside the outer ring, and one that
/// meets the outer ring or another hole elsewhere than in single points. Contract:
/// reference/polygons/point_in_region.h.
Location point_in_region(const Region2d& region, const Point2d& point);

class Region;  // robust/prepared/polygon.h
/// The same without its validation, by the trees of its rings.
Location point_in_region(const Region& region, const Point2d& point);

namespace stages {

/// The latest stage that one of the rings needed.
struct point_in_region : Signatures<Location(const Region2d&, const Point2d&)> {
  static Staged ask;
  static Decided<Location> of_prepared(const Region& region, const Point2d& point);
};

}  // namespace stages

}  // namespace touchstone::robust
