// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/connected_mesh.h"

#include <algorithm>
#include <array>
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

/// A side of a face: a corner and the next; the corners of all faces are numbered consecutively.
struct EdgeOfFace {
  Index low, high;
  std::size_t corner;
  bool along;  ///< from low to high
  bool same_edge(const EdgeOfFace& other) const { return low == other.low && high == other.high; }
};

/// The corners of all faces in order, and for each the one that follows in its face.
struct Corners {
  explicit Corners(const Meshd& mesh) {
    for (std::size_t i = 0; i < named_faces(mesh); ++i) {
      if (mesh.polygons.empty()) add(std::array{mesh.faces[i].a, mesh.faces[i].b, mesh.faces[i].c});
      else add(mesh.polygons[i]);
    }
  }
  template <class Face>
  void add(const Face& corners) {
    const std::size_t first = vertex.size();
    vertex.insert(vertex.end(), corners.begin(), corners.end());
    for (std::size_t k = first + 1; k < vertex.size(); ++k) next.push_back(k);
    next.push_back(first);
  }
  std::vector<Index> vertex;
  std::vector<std::size_t> next;
};

}  // namespace

ConnectedMesh::ConnectedMesh(const Meshd& mesh) {
  const Corners all(mesh);
  const std::vector<Index>& corners = all.vertex;
  std::vector<EdgeOfFace> sides;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Index from = corners[k], to = corners[all.next[k]];
    sides.push_back({std::min(from, to), std::max(from, to), k, from < to});
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeOfFace& s, const EdgeOfFace& t) {
    return s.low != t.low ? s.low < t.low : s.high != t.high ? s.high < t.high : s.corner < t.corner;
  });
  Joined parts(mesh.vertices.size()), fans(corners.size());  // corners at one vertex are joined by the edges there
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [first](const EdgeOfFace& s) { return !s.same_edge(*first); });
    const auto count = last - first, along = std::count_if(first, last, [](const EdgeOfFace&s) { return s.along; });
    const auto note = [first](std::optional<IndexPair>& witness, bool holds) {
      if (!holds && !witness) witness = IndexPair{first->low, first->high};
    };
    ++found.edges;
    note(found.open_edge, count % 2 == 0);
    note(found.turned_edge, std::abs(2 * along - count) <= 1);
    note(found.crowded_edge, count <= 2);
    parts.join(first->low, first->high);
    const auto at = [&all](const EdgeOfFace& s, bool low) { return s.along == low ? s.corner : all.next[s.corner]; };
    for (auto side = first + 1; side != last; ++side) {
      fans.join(at(*first, true), at(*side, true)), fans.join(at(*first, false), at(*side, false));
    }
    first = last;
  }
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
