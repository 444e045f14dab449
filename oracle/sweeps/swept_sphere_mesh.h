// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/ray_mesh.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: for each face that of swept_sphere_triangle.h, on the zeros of the polynomials of face, edges and corners;
/// the least of them by exact comparison.
/// Margin: with a hit at the start the least of those of the named face and the ones before it for the ball at rest;
/// otherwise the least of those of all faces, or 0 if two of them are first met at once; none without faces.
/// Certificate: parts `missed`, each a `normal` along which the ball is beyond all of these `faces` at the start and at
/// the end ("separating_axis"); parts `met`, for each other `face` what swept_sphere_triangle.h says of it ("start",
/// "first_contact"), with the `time` of the contact, p + q sqrt(r), as p, q and r.
template <Exact Number = double>
Truth<FirstFaceContact<Surd>> swept_sphere_mesh(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Mesh<Number>& mesh);

}  // namespace touchstone::oracle
