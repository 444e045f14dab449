// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "oracle/certificates/check_meshes.h"

/// Solids within closed meshes, convex or not.
namespace touchstone::certify {

/// A number of the certificate that counts from 0.
std::size_t index(const Rational& value, std::size_t count);

/// Requires that every edge, an unordered pair of vertices, is in an even number of faces.
void expect_even(const Mesh& mesh, const std::string& what);

/// The point of a triangle that the weights of the certificate give.
Triple from_weights(const Claim& proof, const std::array<Triple, 3>& corners);

/// The location that a certificate of point_in_polyhedron proves for a point and such a mesh: inside, boundary or
/// outside.
std::string proved_location(const Claim& proof, const Mesh& mesh, const Triple& p);

}  // namespace touchstone::certify
