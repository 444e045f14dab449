// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/repeated_faces.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace touchstone::audit::meshes {
namespace {

/// The lexicographically first rotation.
Corners first_rotation(const Corners& corners) {
  const Index least = *std::min_element(corners.begin(), corners.end());
  std::optional<Corners> best;
  for (auto at = corners.begin(); (at = std::find(at, corners.end(), least)) != corners.end(); ++at) {
    Corners rotated(at, corners.end());
    rotated.insert(rotated.end(), corners.begin(), at);
    if (!best || rotated < *best) best = std::move(rotated);
  }
  return *best;
}

struct Ring {
  Corners corners;
  bool reversed;
  std::size_t face;
};

}  // namespace

RepeatedFaces repeated_faces(const std::vector<Corners>& faces) {
  std::vector<Ring> rings;
  rings.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Corners forth = first_rotation(faces[i]), back = first_rotation({faces[i].rbegin(), faces[i].rend()});
    const bool reversed = back < forth;
    rings.push_back({reversed ? std::move(back) : std::move(forth), reversed, i});
  }
  std::sort(rings.begin(), rings.end(),
            [](const Ring& r, const Ring& s) { return std::tie(r.corners, r.face) < std::tie(s.corners, s.face); });
  RepeatedFaces found;
  const Ring* first = nullptr;
  std::vector<const Ring*> firsts;  // the first at a position, one of each direction
  for (const Ring& ring : rings) {
    if (first == nullptr || first->corners != ring.corners) {
      first = &ring, firsts = {first};
      continue;
    }
    const auto same =
        std::find_if(firsts.begin(), firsts.end(), [&](const Ring* r) { return r->reversed == ring.reversed; });
    if (same != firsts.end()) {
      found.same.emplace_back(ring.face, (*same)->face);
    } else {
      found.opposed.emplace_back(ring.face, first->face), firsts.push_back(&ring);
    }
  }
  std::sort(found.same.begin(), found.same.end()), std::sort(found.opposed.begin(), found.opposed.end());
  return found;
}

}  // namespace touchstone::audit::meshes
