// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the points no farther than the radius from the box are the box, and for each face, edge and corner the part
/// of the slab, cylinder or ball around its plane, its line or itself that is over it. So the ball meets the box at 0
/// if its center is in the box, or first where the center enters one of these 26. Each is entered at the first zero of
/// a parabola (parabola.h), a rational or a surd; an entry that is not over the face or edge is none, since an edge or
/// corner there is entered before. The least of the entries is the truth.
///
/// Margin: a difference of squared lengths, with m the least squared distance of the center from the box for t in [0,
/// 1], which is at 0, at 1, or at the vertex of one of the parabolas: |m - r^2|; if the center enters the box, r^2 +
/// d^2, d being how far its path then has to be moved, in the maximum norm (swept_aabb_aabb.h). 0 for a step that only
/// grazes the box, starts with a touch and goes no deeper, or ends with one; not for a touch that goes deeper.
///
/// Certificate: hit at the start: a common `point` ("start"). hit later: on which `sides` of the box the center is at
/// t, axis by axis ("first_contact"). never: a `normal` along which the ball is beyond all of the box at the start and
/// at the end ("separating_axis").
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_sphere_aabb(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                            const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
