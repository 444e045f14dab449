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

/// Every edge, a pair of vertices in whichever order, is in an even number of faces.
template <class Number>
void validate_closed(const std::string& field, const Mesh<Number>& mesh) {
  std::map<std::pair<Index, Index>, int> times;
  for (const Face& face : mesh.faces) {
    for (const auto& [from, to] : edges_of(face)) ++times[std::minmax(from, to)];
  }
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const auto& [from, to] : edges_of(mesh.faces[i])) {
      if (times[std::minmax(from, to)] % 2 != 0) validation::refuse_odd_edge(field, mesh, i, from, to);
    }
  }
}

}  // namespace touchstone::oracle
