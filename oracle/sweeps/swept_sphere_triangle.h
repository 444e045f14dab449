// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the points no farther than the radius from the triangle are, for its face, each edge and each corner, the
/// part of the slab, cylinder or ball around its plane, its line or itself that is over it. So the ball first meets the
/// triangle where the center enters one of these seven, at the first zero of a parabola (parabola.h), if it is over the
/// face or edge then: elsewhere an edge or corner is entered before, as in swept_sphere_aabb.h. The least of the
/// entries is the truth.
///
/// Margin: a difference of squared lengths, with m the least squared distance of the path of the center from the
/// triangle, which is at 0, at 1, or at the vertex of one of the parabolas: |m - r^2|; if the path crosses the
/// triangle, r^2 + d^2, d being the distance by which it has to be moved until it does not. 0 for a step that only
/// grazes the triangle, starts with a touch and goes no deeper, or ends with one; not for a touch that goes deeper.
///
/// Certificate: hit at the start: `weights` of the corners, of a point that is common ("start"). hit later: the
/// `corners`, by index, of the corner, edge or face that is met, and if the ball does not come nearer at t, a `normal`
/// along which the point that is met, going back, leaves the triangle; otherwise zeros ("first_contact"). never: a
/// `normal` along which the ball is beyond all of the triangle at the start and at the end ("separating_axis").
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Triangle3<Number>& triangle);

}  // namespace touchstone::oracle
