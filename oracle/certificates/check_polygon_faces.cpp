// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "oracle/certificates/check_meshes.h"

namespace touchstone::certify {
namespace {

using Triangle = std::array<std::size_t, 3>;
using FaceCorners = std::vector<std::size_t>;

/// A vector perpendicular to the plane of three corners that are not collinear; zero if all are.
Triple across_plane(const std::vector<Triple>& vertices, const FaceCorners& corners) {
  for (const std::size_t b : corners) {
    for (const std::size_t c : corners) {
      const Triple& a = vertices[corners[0]];
      const Triple normal = cross(vertices[b] - a, vertices[c] - a);
      if (!(normal == Triple{0, 0, 0})) return normal;
    }
  }
  return {0, 0, 0};
}

/// A face, its triangles, and a normal of its plane about which they must be counter-clockwise.
struct Cut {
  const std::vector<Triple>& vertices;
  const FaceCorners& corners;
  std::vector<Triangle> triangles;
  Triple across;

  int turn(std::size_t a, std::size_t b, std::size_t c) const {
    return sgn(dot(across, cross(vertices[b] - vertices[a], vertices[c] - vertices[a])));
  }
  bool planar() const {
    return std::all_of(corners.begin(), corners.end(),
                       [this](std::size_t v) { return sgn(dot(across, vertices[v] - vertices[corners[0]])) == 0; });
  }
  /// True if the triangles traverse each edge as often as the face does, forward minus backward.
  bool bounded_alike() const {
    std::map<std::pair<std::size_t, std::size_t>, std::int64_t> runs;
    const auto run = [&runs](std::size_t from, std::size_t to, std::int64_t times) {
      runs[std::minmax(from, to)] += from < to ? times : -times;
    };
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) run(t[k], t[(k + 1) % 3], 1);
    for (std::size_t k = 0; k < corners.size(); ++k) run(corners[k], corners[(k + 1) % corners.size()], -1);
    return std::all_of(runs.begin(), runs.end(), [](const auto& edge) { return edge.second == 0; });
  }
  /// True if all corners of the other triangle are to the right of an edge, or on it.
  bool near_edge(const Triangle& t, const Triangle& other) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto right = [&](std::size_t v) { return turn(t[k], t[(k + 1) % 3], v) <= 0; };
      if (std::all_of(other.begin(), other.end(), right)) return true;
    }
    return false;
  }
  bool holds(const Triangle& t, std::size_t v) const {
    const auto in_its_position = [&](std::size_t corner) { return vertices[corner] == vertices[v]; };
    return std::none_of(t.begin(), t.end(), in_its_position) && turn(t[0], t[1], v) >= 0 && turn(t[1], t[2], v) >= 0 &&
           turn(t[2], t[0], v) >= 0;
  }
};

}  // namespace

void expect_cut(const Mesh& mesh, const std::string& what) {
  const std::string no_cut = what + ".cut: a cut of the faces into triangles";
  for (std::size_t i = 0, first = 0; i < mesh.named.size(); ++i) {
    const FaceCorners& corners = mesh.named[i];
    const std::size_t end = first + corners.size() - 2;
    Cut cut{mesh.vertices,
            corners,
            {mesh.faces.begin() + static_cast<std::ptrdiff_t>(first),
             mesh.faces.begin() + static_cast<std::ptrdiff_t>(end)},
            {}};
    first = end;
    const Triangle& t = cut.triangles[0];
    if (corners.size() == 3) {
      expect(std::equal(corners.begin(), corners.end(), t.begin()), no_cut);
      continue;
    }
    cut.across = across_plane(mesh.vertices, corners);
    if (cut.turn(t[0], t[1], t[2]) < 0) cut.across = Triple{0, 0, 0} - cut.across;
    expect(cut.planar(), numbered(what + ".faces", i) + ": planar");
    expect(cut.bounded_alike(), no_cut);
    for (std::size_t k = 0; k < cut.triangles.size(); ++k) {
      const Triangle& one = cut.triangles[k];
      for (const std::size_t v : one) expect(std::find(corners.begin(), corners.end(), v) != corners.end(), no_cut);
      expect(cut.turn(one[0], one[1], one[2]) > 0, no_cut);
      for (const std::size_t v : corners) expect(!cut.holds(one, v), no_cut);
      for (std::size_t l = 0; l < k; ++l) {
        const Triangle& other = cut.triangles[l];
        expect(cut.near_edge(one, other) || cut.near_edge(other, one), no_cut);
      }
    }
  }
}

}  // namespace touchstone::certify
