// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_mesh.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: for each face, the exact linear program of ray_triangle.h, which gives the least t of a common point and its
/// weights, or a plane that keeps the face from the ray; faces that an earlier plane keeps from it need no other.
/// Margin: the least squared distance of the origin from a triangle, or of the ray from an edge of one, or of the first
/// point from the one at which the ray first meets another face; none without faces. Certificate: `until`, a t from
/// which on the ray is farther ahead than all corners of faces; parts `missed`, planes, each with the `faces` that it
/// keeps from what comes before; parts `met`, for each `face` that the ray meets, t and weights of the first point, and
/// the plane `before`, as in ray_triangle.h. Faces are triangles there, of a cut where faces have more corners.
template <Exact Number = double>
Truth<RayMesh<Rational>> ray_mesh(const Ray3<Number>& ray, const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
