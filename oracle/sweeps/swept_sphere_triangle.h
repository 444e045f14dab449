// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the least of the entries into the seven parts around the face, the edges and the corners
/// (ball_near_polygon.h).
///
/// Margin: a difference of squared lengths, with m the least squared distance of the path of the center from the
/// triangle: |m - r^2|; if the path crosses the triangle, r^2 + d^2, d being the distance by which it has to be moved
/// until it does not. 0 for a step that only grazes the triangle, starts with a touch and goes no deeper, or ends with
/// one; not for a touch that goes deeper.
///
/// Certificate: that of ball_near_polygon.h.
template <Exact Number = double>
Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Triangle3<Number>& triangle);

}  // namespace touchstone::oracle
