// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

/// The corners of all faces in order, and for each the one that follows in its face.
struct FaceCorners {
  std::vector<Index> vertex;
  std::vector<std::size_t> next;

  /// The corners of triangles.
  explicit FaceCorners(const std::vector<Face>& faces) {
    vertex.reserve(3 * faces.size()), next.reserve(3 * faces.size());
    for (const Face& f : faces) add(std::array{f.a, f.b, f.c});
  }
  /// The corners of the faces as they are named.
  explicit FaceCorners(const Meshd& mesh) {
    if (mesh.polygons.empty()) *this = FaceCorners(mesh.faces);
    for (const std::vector<Index>& polygon : mesh.polygons) add(polygon);
  }

 private:
  void add(const auto& corners) {
    const std::size_t first = vertex.size();
    vertex.insert(vertex.end(), corners.begin(), corners.end());
    for (std::size_t k = first + 1; k < vertex.size(); ++k) next.push_back(k);
    next.push_back(first);
  }
};

/// A side of a face, from a corner to the next.
struct EdgeSide {
  Index high;          ///< the greater of the two vertices
  bool along;          ///< from the lesser to the greater
  std::size_t corner;  ///< where it begins
};

/// The sides of all faces by their edges: lesser vertices ascend, then greater ones, then corners. After a
/// counting sort by the lesser vertex, only sides of the same one are compared.
class EdgeSides {
 public:
  EdgeSides(std::size_t vertices, const FaceCorners& corners) : end_(vertices + 1), sides_(corners.vertex.size()) {
    const auto ends = [&corners](std::size_t k) {
      return std::pair{corners.vertex[k], corners.vertex[corners.next[k]]};
    };
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const auto [from, to] = ends(k);
      ++end_[std::min(from, to) + 1];
    }
    for (std::size_t v = 1; v < end_.size(); ++v) end_[v] += end_[v - 1];
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const auto [from, to] = ends(k);
      sides_[end_[std::min(from, to)]++] = {std::max(from, to), from < to, k};
    }
    auto first = sides_.begin();
    for (const std::size_t end : end_) {
      const auto last = sides_.begin() + static_cast<std::ptrdiff_t>(end);
      std::sort(first, last, [](const EdgeSide& s, const EdgeSide& t) {
        return s.high != t.high ? s.high < t.high : s.corner < t.corner;
      });
      first = last;
    }
  }

  /// Calls look(low, first, last) for each edge, with the range of its sides.
  template <class Look>
  void for_each_edge(const Look& look) const {
    auto first = sides_.begin();
    for (Index low = 0; low + 1 < end_.size(); ++low) {
      for (const auto end = sides_.begin() + static_cast<std::ptrdiff_t>(end_[low]); first != end;) {
        const auto last = std::find_if(first, end, [first](const EdgeSide& s) { return s.high != first->high; });
        look(low, first, last);
        first = last;
      }
    }
  }

 private:
  std::vector<std::size_t> end_;  ///< of the sides of which a vertex is the lesser one
  std::vector<EdgeSide> sides_;
};

}  // namespace touchstone::robust::structures
