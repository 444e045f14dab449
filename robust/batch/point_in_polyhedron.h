// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polyhedra.h"
#include "robust/batch/isa/columns.h"

namespace touchstone::robust {
class Solid;
}

namespace touchstone::robust::batch {

/// robust::point_in_polyhedron of one mesh and each point, its Location: inside 0, boundary 1, outside 2. The error of
/// a refused mesh names its field without a row.
void point_in_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                         const Limits& limits = {});
/// The same of a solid that was validated once, by its tree.
void point_in_polyhedron(const Solid& solid, const Points3& points, std::size_t count, std::uint8_t* answers,
                         const Limits& limits = {});

}  // namespace touchstone::robust::batch
