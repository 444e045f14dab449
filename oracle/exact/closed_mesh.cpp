// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/closed_mesh.h"

#include <algorithm>
#include <map>

#include "geometry/closed_mesh.h"

namespace touchstone::oracle {

void validate_closed(const std::string& field, const std::vector<Face>& faces) {
  std::map<std::pair<Index, Index>, int> times;
  for (const Face& face : faces) {
    for (const auto& [from, to] : edges_of(face)) ++times[std::minmax(from, to)];
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const auto& [from, to] : edges_of(faces[i])) {
      if (times[std::minmax(from, to)] % 2 != 0) validation::refuse_odd_edge(field, i, from, to);
    }
  }
}

}  // namespace touchstone::oracle
