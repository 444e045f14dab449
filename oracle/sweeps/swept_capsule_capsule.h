// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the points of b's segment less the displacements along a's make a parallelogram, and the capsules meet where
/// the first end of a, which moves, is no farther from that than both radii together: when it first is, by the nine
/// parts around the face, the edges and the corners (ball_near_polygon.h). robust looks which of them is the nearest.
///
/// Margin: a difference of squared lengths, with m the least squared distance of the segments during the step:
/// |m - (r + s)^2|; if they meet, (r + s)^2 + d^2, d being the distance by which the path of a has to be moved until
/// they do not. 0 for a step in which the capsules only graze each other, that starts with a touch and goes no deeper,
/// or ends with one.
///
/// Certificate: that of ball_near_polygon.h; the corners are b.a, b.b, b.b - u and b.a - u, with u = a.b - a.a.
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_capsule_capsule(const Capsule3<Number>& a, const Capsule3<Number>& b,
                                                const Vector3<Number>& velocity);

}  // namespace touchstone::oracle
