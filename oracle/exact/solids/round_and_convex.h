// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/validation.h"
#include "oracle/exact/shapes/round_solid.h"
#include "oracle/exact/solids/solid_distance.h"

namespace touchstone::oracle {

/// The contact of a ball or a capsule and a convex solid, as contact_of has it of their cores; refuses invalid input.
/// The mesh's core is all its vertices.
template <class Shape, class Number>
Truth<Contact> contact_with_convex(const std::string& field, const Shape& shape, const std::string& field_of_mesh,
                                   const Mesh<Number>& mesh) {
  validation::validate_numbers(field, shape), validation::validate_numbers(field_of_mesh, mesh);
  validate_round(field, shape);
  const ConvexMesh convex(field_of_mesh, mesh);
  const RoundSolid round = round_solid(shape);
  RoundSolid solid{{}, {}};
  for (const auto& p : mesh.vertices) solid.core.push_back(exact(p));
  return contact_of(round, solid, nearest_pair(round.core, convex));
}

}  // namespace touchstone::oracle
