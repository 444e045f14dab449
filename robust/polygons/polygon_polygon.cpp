// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/polygon_polygon.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"
#include "robust/rings/meeting.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

void validate_simple(const char* field, const Polygon2d& polygon) {
  if (const auto defect = ring_defect(polygon)) validation::refuse(field, *defect, polygon.size());
}

}  // namespace

Decided<Contact> stages::polygon_polygon::ask(const Polygon2d& a, const Polygon2d& b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  const validation::OpenRing open_a(a), open_b(b);
  validation::validate("a", a), validate_simple("a", *open_a);
  validation::validate("b", b), validate_simple("b", *open_b);
  return of_prepared({Validated{}, *open_a}, {Validated{}, *open_b});
}

/// Two simple polygons have a common interior point exactly if they have one near a common point of their boundaries
/// (robust/rings/meeting.cpp); or if the boundaries have no common point, and a vertex of one lies inside the other.
/// For if a boundary runs inside the other polygon and the boundaries meet somewhere, then, since it is connected, it
/// leaves some common point towards that inside, and next to it lie interior points of both.
Decided<Contact> stages::polygon_polygon::of_prepared(const SimplePolygon& a, const SimplePolygon& b) {
  const kernel::ControlWord ieee;  // coordinates are compared: flushed denormals would all be 0
  const structures::TreedRing *const of_a[] = {&a.treed()}, *const of_b[] = {&b.treed()};
  auto [found, latest] = contact_of_boundaries(of_a, of_b, CommonEdge::touches);
  if (found != Contact::disjoint) return {found, latest};
  const auto inside = [&latest = latest](const Point2d& p, const SimplePolygon& polygon) {
    return stages::point_in_polygon::of_prepared(polygon, p).noting(latest) == Location::inside;
  };
  if (inside(a.ring()[0], b) || inside(b.ring()[0], a)) found = Contact::overlapping;
  return {found, latest};
}

Contact polygon_polygon(const SimplePolygon& a, const SimplePolygon& b) {
  return stages::polygon_polygon::of_prepared(a, b).answer;
}

Contact polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return stages::polygon_polygon::ask(a, b).answer; }

}  // namespace touchstone::robust
