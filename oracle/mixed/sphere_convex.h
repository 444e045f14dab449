// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: S, the square of the center's distance from the solid, is 0 if the center is behind the planes of all faces.
/// Otherwise it is the least of its squared distances from vertices, edges and faces, all of them tried in integers. It
/// is compared with the square of the radius.
///
/// Margin: |S - r^2|: 0 for a tangent ball, and for a point in the solid.
///
/// Certificate: as that of sphere_obb, with `weights` of all vertices for a point of the solid.
template <Exact Number = double>
Truth<Contact> sphere_convex(const Sphere3<Number>& sphere, const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
