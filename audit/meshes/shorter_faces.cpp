// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/shorter_faces.h"

#include <algorithm>

namespace touchstone::audit::meshes {

bool repeats_corner(const Corners& corners) {
  return corners.front() == corners.back() || std::adjacent_find(corners.begin(), corners.end()) != corners.end();
}

ShorterFaces shorter_faces(const std::vector<Corners>& faces, const std::vector<Index>& into) {
  ShorterFaces result;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Corners corners;
    for (const Index v : faces[i])
      if (corners.empty() || corners.back() != into[v]) corners.push_back(into[v]);
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) {
      result.dropped.push_back(i);
      continue;
    }
    if (corners.size() < faces[i].size()) result.shortened.push_back(i);
    result.faces.push_back(std::move(corners)), result.face_in_file.push_back(i);
  }
  return result;
}

}  // namespace touchstone::audit::meshes
