// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "audit/meshes/merged.h"

namespace touchstone::audit {
namespace {

constexpr std::array tolerances{0.0, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, most_to_suggest};

}  // namespace

std::size_t count_open_edges(const std::vector<std::vector<Index>>& faces) {
  std::vector<std::pair<Index, Index>> edges;
  for (const std::vector<Index>& corners : faces) {
    for (std::size_t k = 0; k < corners.size(); ++k)
      edges.push_back(std::minmax({corners[k], corners[(k + 1) % corners.size()]}));
  }
  std::sort(edges.begin(), edges.end());
  std::size_t open = 0;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first);
    open += static_cast<std::size_t>((last - first) % 2);
    first = last;
  }
  return open;
}

std::optional<MergingThatCloses> merging_that_closes(const std::vector<Point3d>& vertices,
                                                     const std::vector<std::vector<Index>>& faces, std::size_t open) {
  std::optional<MergingThatCloses> best;
  std::size_t merged = 0;
  for (const double tolerance : tolerances) {
    Merging merging = merging_of(vertices, tolerance);
    if (merging.merged == merged) continue;
    merged = merging.merged;
    const std::size_t left = count_open_edges(faces_after(faces, merging));
    if (left < (best ? best->open : open)) best = MergingThatCloses{tolerance, std::move(merging), left, 0, 0, 0};
    if (left == 0) break;
  }
  if (!best) return best;
  for (Index v = 0; v < vertices.size(); ++v) {
    const Index into = best->merging.into[v];
    const Point3d &p = vertices[v], &q = vertices[into];
    const double apart = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
    if (into != v && (best->one == best->other || apart > best->apart))
      best->one = into, best->other = v, best->apart = apart;
  }
  return best;
}

}  // namespace touchstone::audit
