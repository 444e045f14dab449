// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: barycentric weights in the tetrahedra that vertex 0 makes with every face, which fill the solid; a point with
/// a negative one in every tetrahedron is outside, one of the solid in the plane of a face is on the boundary. Margin:
/// the squared distance of the point from a face's plane: inside, from the nearest; outside, from the farthest of those
/// that it lies beyond (so the solid is no nearer than that).
template <Exact Number = double>
Truth<Location> point_in_convex_polyhedron(const Mesh<Number>& mesh, const Point3<Number>& point);

}  // namespace touchstone::oracle
