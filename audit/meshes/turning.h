// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/meshes/surface.h"
#include "geometry/complexity.h"

namespace touchstone::audit::meshes {

/// Which faces have to run the other way.
struct Turning {
  std::vector<std::size_t> turned;         ///< so that they agree with their neighbours
  std::vector<std::size_t> outwards;       ///< so that sheets that agree look outwards, or inwards in an inverse
  std::vector<std::size_t> inside_out;     ///< the first face of each sheet of `outwards`
  std::vector<std::size_t> filled_cavity;  ///< the first face of each sheet inside another that looks outwards as well
};

/// Sheets that are closed and not one-sided come to look outwards, those in an odd number of others inwards; of other
/// sheets the lesser number of faces is turned. A sheet that agrees and lies in another, both looking outwards, may be
/// meant: it is told and stays as it is. Where all sheets of a nest look the wrong way, all are turned: it is the
/// inverse of a hollow solid.
///
/// mesh: the surface cut into triangles, or null where it cannot be cut; nothing but agreement counts then. face_of: of
/// each face that `mesh` names, the face of the surface. nesting: that of its components, or null where it is not
/// known; a sheet that agrees and whose box lies in another's then stays as it is, for it may be a cavity.
Turning turning_of(const Surface& surface, const Meshd* mesh, const std::vector<std::size_t>& face_of,
                   const std::vector<IndexPair>* nesting);

}  // namespace touchstone::audit::meshes
