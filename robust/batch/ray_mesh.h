// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/batch/isa/columns.h"

namespace touchstone::robust {
class Surface;
}

namespace touchstone::robust::batch {

/// robust::ray_mesh_relation of each ray and one mesh, closed or not, its PassageRelation: none 0, hit 1. The error of
/// a refused mesh names its field without a row.
void ray_mesh(const Rays3& rays, const Meshd& mesh, std::size_t count, std::uint8_t* answers,
              const Limits& limits = {});
/// The same of a mesh that was validated once, by its tree.
void ray_mesh(const Rays3& rays, const Surface& mesh, std::size_t count, std::uint8_t* answers,
              const Limits& limits = {});

}  // namespace touchstone::robust::batch
