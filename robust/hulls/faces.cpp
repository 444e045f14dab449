// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/faces.h"

#include <algorithm>
#include <utility>

#include "robust/kernel/machine/parallel.h"

namespace touchstone::robust::hulls {
namespace {

class Merged {
 public:
  Merged(const Surface& surface, std::size_t threads)
      : surface_(surface), flat_(surface.facets.size(), 0), parts_(threads, flat_.size(), 1U << 13) {}

  std::vector<Face> faces() {
    std::vector<std::size_t> begins(parts_.size() + 1, 0);
    std::vector<std::vector<Edge>> flat_edges(parts_.size());
    std::vector<Stage> latest(parts_.size(), Stage::filter);
    parts_.each([&](std::size_t part, std::size_t first, std::size_t last) {
      const Sides sides(surface_.sides, latest[part]);
      for (std::size_t f = first; f < last; ++f) find_flat_edges(static_cast<std::int32_t>(f), sides, flat_edges[part]);
    });
    for (const Stage each : latest) surface_.sides.note(each);
    bool any = false;
    for (const auto& found : flat_edges) {
      for (const auto& [f, i] : found) flat_[static_cast<std::size_t>(f)] |= static_cast<char>(1 << i), any = true;
    }
    parts_.each([&](std::size_t part, std::size_t first, std::size_t last) {
      for (std::size_t f = first; f < last; ++f) begins[part + 1] += is_face(f);
    });
    for (std::size_t part = 0; part < parts_.size(); ++part) begins[part + 1] += begins[part];
    faces_.resize(begins.back());
    parts_.each([&](std::size_t part, std::size_t first, std::size_t last) {
      std::size_t at = begins[part];
      for (std::size_t f = first; f < last; ++f) {
        if (!is_face(f)) continue;
        const Facet& facet = surface_.facets[f];
        std::array<Index, 3> corners{place(facet.corner[0]), place(facet.corner[1]), place(facet.corner[2])};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        faces_[at++] = {corners[0], corners[1], corners[2]};
      }
    });
    if (any) merge();
    put_in_order();
    return std::move(faces_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return surface_.facets[static_cast<std::size_t>(f)]; }
  Index place(std::int32_t corner) const {
    return static_cast<Index>(surface_.points[static_cast<std::size_t>(corner)].place);
  }

  bool is_face(std::size_t f) const { return surface_.facets[f].alive() && flat_[f] == 0; }

  struct Edge {
    std::int32_t facet;
    std::size_t number;
  };
  /// Adds the edges, of both facets, across which facets lie in one plane. Bit i of flat_ says so of edge i.
  void find_flat_edges(std::int32_t f, const Sides& sides, std::vector<Edge>& found) const {
    const Facet& one = facet(f);
    for (std::size_t i = 0; i < 3 && one.alive(); ++i) {
      const std::int32_t g = one.beyond[i];
      if (g < f) continue;
      const Facet& other = facet(g);
      std::size_t back = 0;
      while (other.beyond[back] != f || other.corner[(back + 1) % 3] != one.corner[i]) ++back;
      double height = 0;
      const auto tip = static_cast<std::size_t>(other.corner[(back + 2) % 3]);
      if (sides.of(one, surface_.points[tip], surface_.points, height) != 0) continue;
      found.push_back({f, i}), found.push_back({g, back});
    }
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

  /// Sorts by the first index in one pass, then the few faces that share it; each thread has its range of first
  /// indices.
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
    const kernel::ThreadParts ranges(parts_.size(), ends.size() - 1, 1U << 13);
    ranges.each([&](std::size_t, std::size_t first, std::size_t last) {
      for (const Face& face : faces_)
        if (face.a - first < last - first) ++ends[face.a + 1];
    });
    for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
    std::vector<Face> sorted(faces_.size());
    ranges.each([&](std::size_t, std::size_t first, std::size_t last) {
      const std::size_t start = ends[first];
      for (const Face& face : faces_)
        if (face.a - first < last - first) sorted[ends[face.a]++] = face;
      for (std::size_t begin = start; first < last; ++first) {
        const std::size_t end = ends[first];
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
                  sorted.begin() + static_cast<std::ptrdiff_t>(end), rest);
        begin = end;
      }
    });
    faces_ = std::move(sorted);
  }

  const Surface& surface_;
  std::vector<char> flat_;
  kernel::ThreadParts parts_;  ///< of the facets
  std::vector<std::int32_t> plane_;  ///< by facet: the least facet of its face
  std::vector<Face> faces_;
};

}  // namespace

std::vector<Face> faces_of(const Surface& surface, std::size_t threads) {
  return Merged(surface, threads).faces();
}

}  // namespace touchstone::robust::hulls
