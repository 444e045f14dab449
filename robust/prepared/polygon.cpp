// SPDX-License-Identifier: Apache-2.0
#include "robust/prepared/polygon.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/lines/orientation.h"
#include "robust/rings/before.h"
#include "robust/rings/convexity.h"
#include "robust/rings/meeting.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

const Polygon2d& valid(const std::string& field, const Polygon2d& ring) {
  validation::validate_numbers(field, ring), validation::validate(field, ring);
  return ring;
}

Polygon2d open(const Polygon2d& ring) { return *validation::OpenRing(ring); }

Polygon2d simple(const std::string& field, const Polygon2d& ring) {
  const Polygon2d opened = open(valid(field, ring));
  if (const auto defect = ring_defect(opened)) validation::refuse(field, *defect, opened.size());
  return opened;
}

/// The first vertex in lexicographic order is convex.
Polygon2d counter_clockwise(Polygon2d ring) {
  const kernel::ControlWord ieee;  // coordinates are compared: flushed denormals would all be 0
  const auto first = std::min_element(ring.vertices.begin(), ring.vertices.end(), before);
  const auto i = static_cast<std::size_t>(first - ring.vertices.begin());
  if (orientation(ring.previous(i), ring[i], ring.next(i)) == Side::right)
    std::reverse(ring.vertices.begin(), ring.vertices.end());
  return ring;
}

Polygon2d convex(const std::string& field, const Polygon2d& ring) {
  const Polygon2d opened = open(valid(field, ring));
  Stage latest = Stage::filter;
  validate_convex(field, opened, latest);
  return opened;
}

Polygon2d clockwise(const Polygon2d& ring) {
  Polygon2d other = counter_clockwise(ring);
  std::reverse(other.vertices.begin(), other.vertices.end());
  return other;
}

/// The insides, on the left, are apart, and the boundaries have single points in common at most.
bool touch_in_points(const structures::TreedRing& a, const structures::TreedRing& b) {
  const structures::TreedRing *const of_a[] = {&a}, *const of_b[] = {&b};
  return contact_of_boundaries(of_a, of_b, CommonEdge::overlaps).answer != Contact::overlapping;
}

/// Refuses rings that are no region: outer, clockwise, has the outside to its left.
void validate_holes(const std::string& field, const structures::TreedRing& outer,
                    const std::vector<structures::TreedRing>& holes) {
  const kernel::ControlWord ieee;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Point2d& vertex = holes[i].ring[0];
    if (!touch_in_points(outer, holes[i]) || located_by_turns(outer, vertex) == Location::outside)
      validation::refuse(field, validation::HoleDefect{i, i});
    for (std::size_t j = 0; j < i; ++j) {
      if (!touch_in_points(holes[j], holes[i]) || located_by_turns(holes[j], vertex) == Location::inside ||
          located_by_turns(holes[i], holes[j].ring[0]) == Location::inside)
        validation::refuse(field, validation::HoleDefect{i, j});
    }
  }
}

}  // namespace

Polygon::Polygon(const Polygon2d& ring, const std::string& field)
    : Polygon(Validated{}, open(valid(field, ring))) {}

Polygon::Polygon(Validated, Polygon2d ring) : treed_(std::move(ring)) {}

SimplePolygon::SimplePolygon(const Polygon2d& ring, const std::string& field)
    : SimplePolygon(Validated{}, simple(field, ring)) {}

SimplePolygon::SimplePolygon(Validated, Polygon2d ring)
    : Polygon(Validated{}, counter_clockwise(std::move(ring))) {}

ConvexPolygon::ConvexPolygon(const Polygon2d& ring, const std::string& field)
    : SimplePolygon(Validated{}, convex(field, ring)) {}

Region::Region(const Region2d& region, const std::string& field) {
  validation::validate_numbers(field, region), validation::validate(field, region);
  rings_.emplace_back(Validated{}, counter_clockwise(simple(field + ".outer", region.outer)));
  std::vector<structures::TreedRing> holes;
  for (std::size_t i = 0; i < region.holes.size(); ++i)
    holes.emplace_back(counter_clockwise(simple(validation::named(field, {"holes", i}), region.holes[i])));
  if (!holes.empty()) validate_holes(field, structures::TreedRing(clockwise(rings_[0].ring())), holes);
  for (const structures::TreedRing& hole : holes) rings_.emplace_back(Validated{}, clockwise(hole.ring));
}

std::vector<const structures::TreedRing*> Region::treed() const {
  std::vector<const structures::TreedRing*> found;
  for (const Polygon& ring : rings_) found.push_back(&ring.treed());
  return found;
}

}  // namespace touchstone::robust
