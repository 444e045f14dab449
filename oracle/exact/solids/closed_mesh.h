// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/closed_mesh.h"
#include "geometry/polyhedra.h"

namespace touchstone::oracle {

inline std::array<std::pair<Index, Index>, 3> edges_of(const Face& f) { return {{{f.a, f.b}, {f.b, f.c}, {f.c, f.a}}}; }

/// Requires that every edge, an unordered pair of vertices, is in an even number of faces: tested for triangles, since
/// a diagonal of a triangulation is in two of them.
template <class Number>
void validate_closed(const std::string& field, const Mesh<Number>& mesh) {
  std::map<std::pair<Index, Index>, int> times;
  for (const Face& face : mesh.faces) {
    for (const auto& [from, to] : edges_of(face)) ++times[std::minmax(from, to)];
  }
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < named_faces(mesh); ++i) {
    const std::vector<Index> corners = corners_of_named(mesh, i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index from = corners[k], to = corners[(k + 1) % corners.size()];
      if (times[std::minmax(from, to)] % 2 != 0) validation::refuse_odd_edge(field, mesh, triangle, from, to);
    }
    triangle += corners.size() - 2;
  }
}

}  // namespace touchstone::oracle
