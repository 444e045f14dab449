// SPDX-License-Identifier: Apache-2.0
#include "robust/rings/convexity.h"

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/lines/orientation.h"
#include "robust/rings/before.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

/// Counts from one walk around the ring.
struct Walk {
  std::size_t left = 0, right = 0;  ///< turns
  std::size_t flips = 0;            ///< edges that lead up after one that leads down, or vice versa (lexicographically)
  Side at_first = Side::on;         ///< the turn at the vertex that is lexicographically first
  Stage latest = Stage::filter;
};

Walk walk(const Polygon2d& ring) {
  Walk found;
  const kernel::ControlWord ieee;
  std::size_t first = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Side side = stages::orientation::ask(ring.previous(i), ring[i], ring.next(i)).noting(found.latest);
    found.flips += before(ring.previous(i), ring[i]) != before(ring[i], ring.next(i));
    found.left += side == Side::left, found.right += side == Side::right;
    if (i == 0 || before(ring[i], ring[first])) first = i, found.at_first = side;
  }
  return found;
}

bool repeated_neighbours(const Polygon2d& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (validation::same_position(ring[i], ring.next(i))) return true;
  }
  return false;
}

}  // namespace

Decided<PolygonConvexity> convexity(const Polygon2d& polygon) {
  const PolygonConvexity degenerate{PolygonClass::degenerate, false, Winding::none};
  const PolygonConvexity not_simple{PolygonClass::not_simple, false, Winding::none};
  if (repeated_neighbours(polygon)) return {degenerate, Stage::filter};
  const Walk found = walk(polygon);
  // Neighbours differ, so if no vertex turns, all are on the first edge's line.
  if (found.left == 0 && found.right == 0) return {degenerate, found.latest};
  const bool both = found.left > 0 && found.right > 0;
  if (!both) {
    // If the edges' directions turn one way, they flip twice for each full turn. One full turn: convex (the ring's
    // support function is that of a convex polygon). A simple ring makes one full turn (Hopf's Umlaufsatz), so the
    // others cross. A ring that reverses on itself is not simple and flips more often: if it went up once and down once
    // and reversed at the top, both paths would bend to the same side of that last edge's line, and could not start in
    // one point unless both are that line.
    if (found.flips != 2) return {not_simple, found.latest};
    const bool strict = found.left + found.right == polygon.size();
    return {{PolygonClass::convex, strict, found.left > 0 ? Winding::ccw : Winding::cw}, found.latest};
  }
  if (ring_defect(polygon).has_value()) return {not_simple, found.latest};
  // The lexicographically first vertex is a corner of the convex hull, and its angle is not flat: otherwise one of its
  // neighbours would come before it.
  return {{PolygonClass::concave, false, found.at_first == Side::left ? Winding::ccw : Winding::cw}, found.latest};
}

Side validate_convex(const std::string& field, const Polygon2d& polygon, Stage& latest) {
  const PolygonConvexity found = convexity(polygon).noting(latest);
  const Side inner = found.orientation == Winding::ccw ? Side::left : Side::right;
  if (found.polygon_class == PolygonClass::convex) return inner;
  const auto defect = ring_defect(polygon);
  if (defect && (defect->first == defect->second || found.polygon_class == PolygonClass::not_simple))
    validation::refuse(field, *defect, polygon.size());
  if (found.polygon_class == PolygonClass::degenerate) validation::refuse_flat(field);
  for (std::size_t i = 0;; ++i) {
    const Side turn = orientation(polygon.previous(i), polygon[i], polygon.next(i));
    if (turn != inner && turn != Side::on) validation::refuse_reflex(field, i);
  }
}

}  // namespace touchstone::robust
