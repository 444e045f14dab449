// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/meshes/surface.h"
#include "geometry/complexity.h"

namespace touchstone::audit::meshes {

/// Which faces have to run the other way.
struct Turning {
  std::vector<std::size_t> turned;         ///< so that they agree with their neighbours
  std::vector<std::size_t> outwards;       ///< so that sheets that agree look outwards
  std::vector<std::size_t> inside_out;     ///< the first face of each sheet of `outwards`
  std::vector<std::size_t> filled_cavity;  ///< the first face of each sheet inside another that looks outwards as well
};

/// Sheets that are closed and not one-sided come to look outwards, those in an odd number of others inwards; of the
/// others the lesser number of faces is turned. `mesh` is the surface cut into triangles, or null where it cannot be cut:
/// nothing but agreement counts then; `face_of` says of each of its named faces which face of the surface it is of. `nesting` is that of its components, or null where it is not
/// known: a sheet that agrees and whose box lies in another's stays as it is, for it may be a cavity. A sheet inside
/// another that looks outwards may be meant: it is told and stays as it is.
Turning turning_of(const Surface& surface, const Meshd* mesh, const std::vector<std::size_t>& face_of,
                   const std::vector<IndexPair>* nesting);

}  // namespace touchstone::audit::meshes
