// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/lattice_hull.h"

#include <set>

#include "catalogue/numbers/lexicographic.h"

namespace touchstone::catalogue {
namespace {

/// The corners of a face of the hull, counter-clockwise about the normal, those on its edges left out (gift wrapping).
std::vector<Index> corners(const std::vector<LatticePoint>& points, const std::vector<Index>& members,
                           const LatticePoint& normal) {
  std::vector<Index> ring{members[0]};
  for (const Index m : members) {
    if (points[m] < points[ring[0]]) ring[0] = m;
  }
  do {
    Index next = members[0] == ring.back() ? members[1] : members[0];
    for (const Index m : members) {
      if (m == ring.back()) continue;
      const LatticePoint v = minus(points[next], points[ring.back()]), w = minus(points[m], points[ring.back()]);
      const std::int64_t turn = dot(normal, cross(v, w));
      if (turn < 0 || (turn == 0 && dot(w, w) > dot(v, v))) next = m;
    }
    ring.push_back(next);
  } while (ring.back() != ring[0]);
  ring.pop_back();
  return ring;
}

Point3d as_doubles(const LatticePoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

}  // namespace

Meshd lattice_hull(const std::vector<LatticePoint>& points) {
  Meshd mesh;
  for (const LatticePoint& p : points) mesh.vertices.push_back(as_doubles(p));
  std::set<std::vector<Index>, Lexicographic> seen;
  const auto count = static_cast<Index>(points.size());
  for (Index i = 0; i < count; ++i) {
    for (Index j = i + 1; j < count; ++j) {
      for (Index k = j + 1; k < count; ++k) {
        LatticePoint normal = cross(minus(points[j], points[i]), minus(points[k], points[i]));
        if (normal == LatticePoint{0, 0, 0}) continue;
        std::vector<Index> members;
        bool front = false, back = false;
        for (Index m = 0; m < count && !(front && back); ++m) {
          const std::int64_t side = dot(normal, minus(points[m], points[i]));
          front = front || side > 0;
          back = back || side < 0;
          if (side == 0) members.push_back(m);
        }
        if (front == back || !seen.insert(members).second) continue;
        if (front) normal = {-normal[0], -normal[1], -normal[2]};
        const std::vector<Index> ring = corners(points, members, normal);
        for (std::size_t c = 1; c + 1 < ring.size(); ++c) mesh.faces.push_back({ring[0], ring[c], ring[c + 1]});
      }
    }
  }
  return mesh;
}

}  // namespace touchstone::catalogue
