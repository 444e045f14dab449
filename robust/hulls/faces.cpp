// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/faces.h"

#include <algorithm>
#include <utility>

namespace touchstone::robust::hulls {
namespace {

class Merged {
 public:
  explicit Merged(const Surface& surface) : surface_(surface), flat_(surface.facets.size(), 0) {}

  std::vector<Face> faces() {
    bool any = false;
    for (std::size_t f = 0; f < flat_.size(); ++f) any = find_flat_edges(static_cast<std::int32_t>(f)) || any;
    for (std::size_t f = 0; f < flat_.size(); ++f) {
      const Facet& facet = surface_.facets[f];
      if (!facet.alive() || flat_[f] != 0) continue;
      std::array<Index, 3> corners{place(facet.corner[0]), place(facet.corner[1]), place(facet.corner[2])};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      faces_.push_back({corners[0], corners[1], corners[2]});
    }
    if (any) merge();
    put_in_order();
    return std::move(faces_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return surface_.facets[static_cast<std::size_t>(f)]; }
  Index place(std::int32_t corner) const {
    return static_cast<Index>(surface_.points[static_cast<std::size_t>(corner)].place);
  }

  /// Bit i of flat_ is set if a coplanar facet lies across edge i.
  bool find_flat_edges(std::int32_t f) {
    const Facet& one = facet(f);
    bool any = false;
    for (std::size_t i = 0; i < 3 && one.alive(); ++i) {
      const std::int32_t g = one.beyond[i];
      if (g < f) continue;
      const Facet& other = facet(g);
      std::size_t back = 0;
      while (other.beyond[back] != f || other.corner[(back + 1) % 3] != one.corner[i]) ++back;
      double height = 0;
      const auto tip = static_cast<std::size_t>(other.corner[(back + 2) % 3]);
      if (surface_.sides.of(one, surface_.points[tip], surface_.points, height) != 0) continue;
      flat_[static_cast<std::size_t>(f)] |= static_cast<char>(1 << i);
      flat_[static_cast<std::size_t>(g)] |= static_cast<char>(1 << back);
      any = true;
    }
    return any;
  }

  bool flat(std::int32_t f, std::size_t i) const { return (flat_[static_cast<std::size_t>(f)] >> i & 1) != 0; }

  void merge() {
    plane_.assign(flat_.size(), -1);
    std::vector<std::int32_t> planes, members;
    for (std::size_t f = 0; f < flat_.size(); ++f) {
      if (!surface_.facets[f].alive() || plane_[f] >= 0) continue;
      const auto number = static_cast<std::int32_t>(f);
      plane_[f] = number;
      if (flat_[f] == 0) continue;
      planes.push_back(number);
      for (members.assign(1, number); !members.empty();) {
        const std::int32_t g = members.back();
        members.pop_back();
        for (std::size_t i = 0; i < 3; ++i) {
          const std::int32_t beyond = facet(g).beyond[i];
          if (!flat(g, i) || plane_[static_cast<std::size_t>(beyond)] >= 0) continue;
          plane_[static_cast<std::size_t>(beyond)] = number;
          members.push_back(beyond);
        }
      }
    }
    std::vector<std::int32_t> at_rim(flat_.size(), -1);
    for (std::size_t f = 0; f < flat_.size(); ++f) {
      if (flat_[f] != 0 && flat_[f] != 7) at_rim[static_cast<std::size_t>(plane_[f])] = static_cast<std::int32_t>(f);
    }
    for (const std::int32_t plane : planes) cut(rim(at_rim[static_cast<std::size_t>(plane)]));
  }

  /// The corners around the rim of a face, from a facet that has an edge in it. A corner is extreme if the faces beyond
  /// its two edges differ; if they are one face, the corner lies inside an edge of the hull.
  std::vector<Index> rim(std::int32_t start) const {
    std::vector<std::pair<Index, std::int32_t>> edges;  // its start, and the face beyond it
    std::int32_t f = start;
    std::size_t i = 0;
    while (flat(f, i)) ++i;
    const std::size_t first = i;
    do {
      edges.push_back({place(facet(f).corner[i]), plane_[static_cast<std::size_t>(facet(f).beyond[i])]});
      i = (i + 1) % 3;
      while (flat(f, i)) {  // around the corner
        const std::int32_t corner = facet(f).corner[i];
        f = facet(f).beyond[i];
        for (i = 0; facet(f).corner[i] != corner; ++i) {
        }
      }
    } while (f != start || i != first);
    std::vector<Index> corners;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      if (edges[k].second != edges[k == 0 ? edges.size() - 1 : k - 1].second) corners.push_back(edges[k].first);
    }
    return corners;
  }

  void cut(std::vector<Index> corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t k = 2; k < corners.size(); ++k) faces_.push_back({corners[0], corners[k - 1], corners[k]});
  }

  /// Sorts by the first index in one pass, then the few faces that share it.
  void put_in_order() {
    Index most = 0;
    for (const Face& face : faces_) most = std::max(most, face.a);
    const auto rest = [](const Face& p, const Face& q) { return p.b != q.b ? p.b < q.b : p.c < q.c; };
    if (most / 8 > faces_.size()) {
      std::sort(faces_.begin(), faces_.end(),
                [&](const Face& p, const Face& q) { return p.a != q.a ? p.a < q.a : rest(p, q); });
      return;
    }
    std::vector<Index> ends(most + 2, 0);
    for (const Face& face : faces_) ++ends[face.a + 1];
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    std::vector<Face> sorted(faces_.size());
    for (const Face& face : faces_) sorted[ends[face.a]++] = face;
    for (std::size_t begin = 0; begin < sorted.size();) {
      const std::size_t end = ends[sorted[begin].a];
      std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin), sorted.begin() + static_cast<std::ptrdiff_t>(end),
                rest);
      begin = end;
    }
    faces_ = std::move(sorted);
  }

  const Surface& surface_;
  std::vector<char> flat_;
  std::vector<std::int32_t> plane_;  ///< by facet: the least facet of its face
  std::vector<Face> faces_;
};

}  // namespace

std::vector<Face> faces_of(const Surface& surface) { return Merged(surface).faces(); }

}  // namespace touchstone::robust::hulls
