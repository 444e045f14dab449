// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/polyhedra.h"

namespace touchstone::catalogue {

struct NamedMesh {
  std::string name;  ///< a file's name, without folder and ending: small letters, digits, '_'
  Meshd mesh;
};

/// Closed convex meshes too large to be repeated in every test vector: vectors name them, and `vectors write` writes
/// each into a file of its own. Faces are counter-clockwise from outside; coordinates, before any scaling, are
/// multiples of 12, so that the middles of edges and faces are exact.
const std::vector<NamedMesh>& named_meshes();

/// The same of meshes that are closed and not convex: a ring of cubes, cubes around a hollow, a star.
const std::vector<NamedMesh>& named_solids();

/// Closed, not convex, and longer than an index of 8 bits reaches; the vertices run from one end to the other.
const std::vector<NamedMesh>& long_solids();

}  // namespace touchstone::catalogue
