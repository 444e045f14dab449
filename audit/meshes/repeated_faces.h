// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "audit/meshes/surface.h"

namespace touchstone::audit::meshes {

/// Faces with the same corners as an earlier one, each with that one: in the same order, or in the opposite one. The
/// corner at which a face begins does not matter. In ascending order.
struct RepeatedFaces {
  std::vector<std::pair<std::size_t, std::size_t>> same, opposed;
};

RepeatedFaces repeated_faces(const std::vector<Corners>& faces);

}  // namespace touchstone::audit::meshes
