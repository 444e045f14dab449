// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: S, the square of the distance of the segment from the solid, is 0 if one of its points is behind the planes
/// of all faces. Otherwise it is the least of the squared distances of its ends and itself from vertices, edges and
/// faces, all of them tried in integers. It is compared with the square of the radius.
///
/// Margin: |S - r^2|: 0 for a tangent capsule, and for a segment that meets the solid.
///
/// Certificate: as that of capsule_obb, with `on_b`, weights of all vertices.
template <Exact Number = double>
Truth<Contact> capsule_convex(const Capsule3<Number>& capsule, const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
