// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/region_region.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/polygons/point_in_region.h"
#include "robust/prepared/polygon.h"
#include "robust/rings/meeting.h"

namespace touchstone::robust {

Decided<Contact> stages::region_region::ask(const Region2d& a, const Region2d& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const Region of_a(a, "a");
  return of_prepared(of_a, Region(b, "b"));
}

/// Two regions have a common interior point exactly if they have one near a common point of their boundaries
/// (robust/rings/meeting.cpp), or if the first vertex of a ring lies inside the other region. For a ring that runs
/// inside the other region either lies there entirely, or it leaves a common point of the boundaries towards that
/// inside. If no ring does either, then all that bounds a common inside is a piece of both boundaries, with both
/// insides on one side, at the ends of the piece too.
Decided<Contact> stages::region_region::of_prepared(const Region& a, const Region& b) {
  const kernel::ControlWord ieee;  // coordinates are compared: flushed denormals would all be 0
  const auto of_a = a.treed(), of_b = b.treed();
  auto [found, latest] = contact_of_boundaries(of_a, of_b, CommonEdge::touches);
  const auto any_inside = [&latest = latest](const Region& one, const Region& other) {
    return std::any_of(one.rings().begin(), one.rings().end(), [&](const Polygon& ring) {
      return stages::point_in_region::of_prepared(other, ring.ring()[0]).noting(latest) == Location::inside;
    });
  };
  if (found != Contact::overlapping && (any_inside(a, b) || any_inside(b, a))) found = Contact::overlapping;
  return {found, latest};
}

Contact region_region(const Region& a, const Region& b) { return stages::region_region::of_prepared(a, b).answer; }

Contact region_region(const Region2d& a, const Region2d& b) { return stages::region_region::ask(a, b).answer; }

}  // namespace touchstone::robust
