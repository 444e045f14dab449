// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/meshes/surface.h"
#include "geometry/complexity.h"

namespace touchstone::audit::meshes {

/// The faces that have to be reversed.
struct Turning {
  std::vector<std::size_t> turned;         ///< so that they agree with their neighbours
  std::vector<std::size_t> outwards;       ///< so that consistent sheets look outwards, or inwards in an inverse
  std::vector<std::size_t> inside_out;     ///< the first face of each sheet of `outwards`
  std::vector<std::size_t> filled_cavity;  ///< the first face of each sheet inside another that looks outwards as well
};

/// Closed sheets that are not one-sided are made to look outwards, those in an odd number of others inwards; in other
/// sheets the smaller set of faces is reversed. A consistent sheet inside another, both looking outwards, may be
/// intended: it is reported and not changed. If all sheets of a nest have the wrong orientation, all are reversed: it
/// is the inverse of a hollow solid.
///
/// mesh: the triangulated surface, or null if it cannot be triangulated; then only consistency counts. face_of: for
/// each face of `mesh`, the face of the surface. nesting: that of its components, or null if it is unknown; a
/// consistent sheet whose box lies in another's is then not changed, since it may be a cavity.
Turning turning_of(const Surface& surface, const Meshd* mesh, const std::vector<std::size_t>& face_of,
                   const std::vector<IndexPair>* nesting);

}  // namespace touchstone::audit::meshes
