// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/connected_mesh.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace touchstone::robust::structures {
namespace {

/// Disjoint sets of numbers.
class Joined {
 public:
  explicit Joined(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (up_[i] != i) i = up_[i] = up_[up_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t p = root(i), q = root(j);
    up_[std::max(p, q)] = std::min(p, q);
  }

 private:
  std::vector<std::size_t> up_;
};

}  // namespace

ConnectedMesh::ConnectedMesh(const Meshd& mesh) : ConnectedMesh(mesh, FaceCorners(mesh)) {}

ConnectedMesh::ConnectedMesh(const Meshd& mesh, const FaceCorners& all) : sides(mesh.vertices.size(), all) {
  const std::vector<Index>& corners = all.vertex;
  Joined parts(mesh.vertices.size()), fans(corners.size());  // corners at one vertex are joined by the edges there
  sides.for_each_edge([&](Index low, const auto first, const auto last) {
    const auto count = last - first, along = std::count_if(first, last, [](const EdgeSide& s) { return s.along; });
    const auto note = [low, first](std::optional<IndexPair>& witness, bool holds) {
      if (!holds && !witness) witness = IndexPair{low, first->high};
    };
    ++found.edges;
    note(found.open_edge, count % 2 == 0);
    note(found.turned_edge, std::abs(2 * along - count) <= 1);
    note(found.crowded_edge, count <= 2);
    parts.join(low, first->high);
    const auto at = [&all](const EdgeSide& s, bool of_low) {
      return s.along == of_low ? s.corner : all.next[s.corner];
    };
    for (auto side = first + 1; side != last; ++side) {
      fans.join(at(*first, true), at(*side, true)), fans.join(at(*first, false), at(*side, false));
    }
  });
  std::vector<bool> used(mesh.vertices.size());
  std::vector<std::size_t> fan(mesh.vertices.size());  // of the first corner
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Index v = corners[k];
    if (!used[v]) fan[v] = fans.root(k), ++found.vertices;
    used[v] = true;
    if (fans.root(k) != fan[v]) found.pinched_vertex = std::min(v, found.pinched_vertex.value_or(v));
  }
  std::vector<std::optional<Index>> number(mesh.vertices.size());  // of the component with this root
  for (const Face& f : mesh.faces) {
    auto& of_part = number[parts.root(f.a)];
    if (!of_part) of_part = found.components++;
    component.push_back(*of_part);
  }
  found.faces = static_cast<Index>(named_faces(mesh));
  found.euler = static_cast<double>(std::int64_t{found.vertices} - found.edges + found.faces);
  found.closed = !found.open_edge, found.oriented = !found.turned_edge, found.edge_manifold = !found.crowded_edge;
  found.vertex_manifold = found.edge_manifold && !found.pinched_vertex;
}

}  // namespace touchstone::robust::structures
