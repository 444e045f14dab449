// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {

/// A ball that moves, and a convex polygon at rest, of three corners or more in order, or without area: then it is the
/// segment or the point that they span. Corners that follow one another may coincide; in a polygon with area, no corner
/// is between others, and the first three are not on one line.
struct BallNearPolygon {
  Hull corners;
  Point3<Rational> center;
  Vector3<Rational> velocity;
  Rational radius;
};

/// The points no farther than the radius from the polygon are, for its face, each edge and each corner, the part of the
/// slab, cylinder or ball around its plane, its line or itself that is over it. So the ball first meets the polygon
/// where the center enters one of these, at the first zero of a parabola (parabola.h), if it is over the face or edge
/// then: elsewhere an edge or corner is entered before, as in swept_sphere_aabb.h. The least of the entries is the
/// truth.
///
/// Margin: a difference of squared lengths, with m the least squared distance of the path of the center from the
/// polygon, which is at 0, at 1, or at the vertex of one of the parabolas: |m - r^2|; if the path crosses the polygon,
/// r^2 + d^2, d being the distance by which it has to be moved until it does not.
///
/// Certificate: hit at the start: `weights` of the corners, of a point that is common ("start"). hit later: the
/// `corners`, by index, of the corner, edge or face that is met, and if the ball does not come nearer at t, a `normal`
/// along which the point that is met, going back, leaves the polygon; otherwise zeros ("first_contact"). never: a
/// `normal` along which the ball is beyond all of the polygon at the start and at the end ("separating_axis").
Truth<FirstContact<Surd>> first_contact(BallNearPolygon ball);

}  // namespace touchstone::oracle
