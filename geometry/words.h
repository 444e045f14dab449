// SPDX-License-Identifier: Apache-2.0
#pragma once

/// The words of answers. An enumerator is a word of the contract.
namespace touchstone {

/// Where a point lies of a directed line p0 -> p1: `left` is counter-clockwise (y up).
enum class Side { left, on, right };

/// Where a point lies of a line that is not vertical; above is +y.
enum class Height { above, on, below };

/// Where a point lies of a solid: its interior, its boundary, or neither.
enum class Location { inside, boundary, outside };

/// Whether a point lies on a thin closed shape.
enum class Incidence { on, off };

enum class LineRelation { crossing, parallel, same };
enum class SegmentRelation { disjoint, point, overlap };
enum class RayRelation { none, point, overlap };

/// Whether two solids have a common point, and a common interior point.
enum class Contact { disjoint, touching, overlapping };

/// `degenerate`: repeated neighbours, or all vertices on one line. `not_simple`: the ring meets itself elsewhere.
enum class PolygonClass { convex, concave, not_simple, degenerate };
enum class Winding { ccw, cw, none };

/// Where a point lies of a plane; the front is where the normal points.
enum class PlaneSide { front, on, back };
/// `degenerate`: the normal is the zero vector.
enum class NormalClass { proper, degenerate };
enum class HitRelation { hit, never };

/// The coordinate axes.
enum class Axis { x, y, z };

}  // namespace touchstone
