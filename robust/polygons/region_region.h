// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two regions, polygons with holes, are `disjoint`, only touch or overlap.
///
/// `overlapping`: they have a common interior point. `touching`: their intersection lies on both boundaries; so does
/// that of a polygon and a region whose hole it fills. Right for all finite doubles in every floating-point
/// environment. Refusals are those of point_in_region, of a before those of b. Contract:
/// reference/polygons/region_region.h.
Contact region_region(const Region2d& a, const Region2d& b);

class Region;  // robust/prepared/polygon.h
/// The same without its validation.
Contact region_region(const Region& a, const Region& b);

namespace stages {

/// The latest stage that one of its decisions needed.
struct region_region : Signatures<Contact(const Region2d&, const Region2d&)> {
  static Staged ask;
  static Decided<Contact> of_prepared(const Region& a, const Region& b);
};

}  // namespace stages

}  // namespace touchstone::robust
