// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/validation.h"

namespace touchstone::validation {

/// The reason why a mesh has no inside and outside: an edge, a pair of vertices in whichever order, in an odd number of
/// faces. The first such face counts, and in it the first edge in the order of its corners. triangle: one of that face.
template <class Real>
[[noreturn]] void refuse_odd_edge(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle, Index from,
                                  Index to) {
  const std::string edge = "from vertex " + std::to_string(from) + " to vertex " + std::to_string(to);
  refuse_face(field, mesh, triangle, "closed: the edge " + edge + " must be in an even number of faces");
}

}  // namespace touchstone::validation
