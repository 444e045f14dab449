// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polyhedra.h"

namespace touchstone::oracle {

inline std::array<std::pair<Index, Index>, 3> edges_of(const Face& f) { return {{{f.a, f.b}, {f.b, f.c}, {f.c, f.a}}}; }

/// Every edge, a pair of vertices in whichever order, is in an even number of faces.
void validate_closed(const std::string& field, const std::vector<Face>& faces);

}  // namespace touchstone::oracle
