// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/point_mesh_distance.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: for each face whose box is near enough, the point of least squared distance, in rationals, by the conditions
/// of Karush, Kuhn and Tucker (oracle/exact/shapes/nearest_pair.h); the least of them has to be the distance by feet of
/// perpendiculars that is the margin of point_in_polyhedron.h. Location and margin are as there.
///
/// Certificate: "root" or "irrational_root", as closest_point_on_segment has them; `face`, the first triangle that has
/// the point; `weights` of its corners; part `location`, one proof of point_in_polyhedron.
template <Exact Number = double>
Truth<PointMeshDistance<Surd>> point_mesh_distance(const Point3<Number>& point, const Mesh<Number>& mesh);

/// The truth with that of the nearest points which is nearest to `other`. No other truth rests on it.
PointMeshDistance<Surd> as_near(const Point3d& point, const Meshd& mesh, const PointMeshDistance<Surd>& truth,
                                const Point3d& other);

}  // namespace touchstone::oracle
