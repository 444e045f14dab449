// SPDX-License-Identifier: Apache-2.0
#include "robust/prepared/polygon.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/lines/orientation.h"
#include "robust/rings/before.h"
#include "robust/rings/convexity.h"
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

}  // namespace

Polygon::Polygon(const Polygon2d& ring, const std::string& field)
    : Polygon(Validated{}, open(valid(field, ring))) {}

Polygon::Polygon(Validated, Polygon2d ring) : ring_(std::move(ring)), tree_(ring_) {}

SimplePolygon::SimplePolygon(const Polygon2d& ring, const std::string& field)
    : SimplePolygon(Validated{}, simple(field, ring)) {}

SimplePolygon::SimplePolygon(Validated, Polygon2d ring)
    : Polygon(Validated{}, counter_clockwise(std::move(ring))) {}

ConvexPolygon::ConvexPolygon(const Polygon2d& ring, const std::string& field)
    : SimplePolygon(Validated{}, convex(field, ring)) {}

}  // namespace touchstone::robust
