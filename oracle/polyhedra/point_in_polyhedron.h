// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: `boundary` if barycentric coordinates in a face give the point. Otherwise the parity of the faces that a ray
/// crosses whose line misses every edge, as is made sure of each; three such rays in directions far from one another
/// have to agree. Margin: the least squared distance of the point from a face.
///
/// Certificate: boundary: "on_face" (the `face` and the `weights` of its corners). inside, outside: "crossings" (the
/// ray's `direction`, the `faces` that it crosses, and `t`, at which it does).
template <Exact Number = double>
Truth<Location> point_in_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point);

}  // namespace touchstone::oracle
