// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/members.h"

/// The words of answers. An enumerator is a word of the contract. `plain_false` is the enumerator of "no common point"
/// and of "not in the closed shape", which a yes-or-no answer has as its no.
namespace touchstone {

/// The side of a directed line p0 -> p1 on which a point lies: `left` is counter-clockwise (y up).
enum class Side { left, on, right };
constexpr auto words_of(Side) { return as_words("left", "on", "right"); }

/// The position of a point relative to a line that is not vertical; above is +y.
enum class Height { above, on, below };
constexpr auto words_of(Height) { return as_words("above", "on", "below"); }

/// Where a point lies of a solid: its interior, its boundary, or neither.
enum class Location { inside, boundary, outside };
constexpr auto words_of(Location) { return as_words("inside", "boundary", "outside"); }
constexpr auto plain_false(Location) { return Location::outside; }

/// Decides whether a point lies on a thin closed shape.
enum class Incidence { on, off };
constexpr auto words_of(Incidence) { return as_words("on", "off"); }
constexpr auto plain_false(Incidence) { return Incidence::off; }

enum class LineRelation { crossing, parallel, same };
constexpr auto words_of(LineRelation) { return as_words("crossing", "parallel", "same"); }
constexpr auto plain_false(LineRelation) { return LineRelation::parallel; }
enum class SegmentRelation { disjoint, point, overlap };
constexpr auto words_of(SegmentRelation) { return as_words("disjoint", "point", "overlap"); }
constexpr auto plain_false(SegmentRelation) { return SegmentRelation::disjoint; }
enum class RayRelation { none, point, overlap };
constexpr auto words_of(RayRelation) { return as_words("none", "point", "overlap"); }
constexpr auto plain_false(RayRelation) { return RayRelation::none; }

/// Decides whether two solids have a common point, and a common interior point.
enum class Contact { disjoint, touching, overlapping };
constexpr auto words_of(Contact) { return as_words("disjoint", "touching", "overlapping"); }
constexpr auto plain_false(Contact) { return Contact::disjoint; }

/// `degenerate`: repeated neighbours, or all vertices on one line. `not_simple`: the ring meets itself elsewhere.
enum class PolygonClass { convex, concave, not_simple, degenerate };
constexpr auto words_of(PolygonClass) { return as_words("convex", "concave", "not_simple", "degenerate"); }
enum class Winding { ccw, cw, none };
constexpr auto words_of(Winding) { return as_words("ccw", "cw", "none"); }

/// The side of a plane on which a point lies; the normal points to the front.
enum class PlaneSide { front, on, back };
constexpr auto words_of(PlaneSide) { return as_words("front", "on", "back"); }
/// `degenerate`: the normal is the zero vector.
enum class NormalClass { proper, degenerate };
constexpr auto words_of(NormalClass) { return as_words("proper", "degenerate"); }
enum class HitRelation { hit, never };
constexpr auto words_of(HitRelation) { return as_words("hit", "never"); }
constexpr auto plain_false(HitRelation) { return HitRelation::never; }

/// The coordinate axes.
enum class Axis { x, y, z };
constexpr auto words_of(Axis) { return as_words("x", "y", "z"); }

}  // namespace touchstone
