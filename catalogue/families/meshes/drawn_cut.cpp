// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/drawn_cut.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>

namespace touchstone::catalogue {
namespace {

using oracle::Integer;
using oracle::IntegerCloud;
using Corners = std::vector<Index>;
using Axis = Integer Vector3<Integer>::*;

Vector3<Integer> doubled_area(const IntegerCloud& cloud, const Corners& corners) {
  Vector3<Integer> sum{0, 0, 0};
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) sum = sum + cloud.normal(corners[0], corners[k], corners[k + 1]);
  return sum;
}

/// Every triangulation of a polygon has a triangle on the edge from its last corner to its first, and on either side of
/// that triangle a smaller polygon, or nothing.
class Cutting {
 public:
  /// Projected along the axis the polygon has an area of this sign.
  Cutting(const IntegerCloud& cloud, const Corners& corners, Axis axis, int sign, DrawStream& draws)
      : cloud_(cloud), corners_(corners), axis_(axis), sign_(sign), draws_(draws) {}

  /// The triangles of the polygon from the corner `first` to `last`, without the edge between these.
  bool cut(std::size_t first, std::size_t last) {
    const std::size_t between = last - first - 1;
    if (between == 0) return true;
    if (without_cut_.contains({first, last})) return false;
    const std::size_t kept = triangles.size(), start = draws_.below(between);
    for (std::size_t k = 0; k < between; ++k) {
      const std::size_t middle = first + 1 + (start + k) % between;
      const Face face{corners_[first], corners_[middle], corners_[last]};
      if (!fits(face)) continue;
      triangles.push_back(face);
      if (cut(first, middle) && cut(middle, last)) return true;
      triangles.resize(kept);
    }
    without_cut_.insert({first, last});
    return false;
  }
  bool overlap() const {
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!beside(triangles[i], triangles[j]) && !beside(triangles[j], triangles[i])) return true;
    return false;
  }

  std::vector<Face> triangles;

 private:
  int turn(Index p, Index q, Index r) const { return sign_ * sgn(Integer(cloud_.normal(p, q, r).*axis_)); }
  bool same(Index p, Index q) const { return cloud_[p] == cloud_[q]; }
  /// It turns as the polygon does, and no corner lies in it but in the positions of its own.
  bool fits(const Face& f) const {
    if (turn(f.a, f.b, f.c) <= 0) return false;
    return std::none_of(corners_.begin(), corners_.end(), [&](Index v) {
      if (same(v, f.a) || same(v, f.b) || same(v, f.c)) return false;
      return turn(f.a, f.b, v) >= 0 && turn(f.b, f.c, v) >= 0 && turn(f.c, f.a, v) >= 0;
    });
  }
  /// An edge of f has all of g on its other side.
  bool beside(const Face& f, const Face& g) const {
    const std::array<Index, 4> ring{f.a, f.b, f.c, f.a};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto outside = [&](Index v) { return turn(ring[k], ring[k + 1], v) <= 0; };
      if (outside(g.a) && outside(g.b) && outside(g.c)) return true;
    }
    return false;
  }

  const IntegerCloud& cloud_;
  const Corners& corners_;
  Axis axis_;
  int sign_;
  DrawStream& draws_;
  std::set<std::pair<std::size_t, std::size_t>> without_cut_;
};

}  // namespace

std::optional<std::vector<Face>> PolygonCutter::cut(const Corners& corners, DrawStream& draws) const {
  const Vector3<Integer> area = doubled_area(cloud_, corners);
  for (const Axis axis : {&Vector3<Integer>::x, &Vector3<Integer>::y, &Vector3<Integer>::z}) {
    const int sign = sgn(area.*axis);
    if (sign == 0) continue;
    const oracle::SupportingPlane plane = cloud_.plane(area, corners[0]);
    const auto off = [&](Index v) { return sgn(cloud_.height(plane, v)) != 0; };
    if (std::any_of(corners.begin(), corners.end(), off)) return std::nullopt;
    Cutting cutting(cloud_, corners, axis, sign, draws);
    if (!cutting.cut(0, corners.size() - 1) || cutting.overlap()) return std::nullopt;
    return std::move(cutting.triangles);
  }
  return std::nullopt;
}

Meshd cut_mesh(std::vector<Point3d> vertices, std::vector<Corners> polygons, DrawStream& draws) {
  const PolygonCutter cutter(vertices);
  Meshd mesh{std::move(vertices), {}, {}};
  const auto triangle = [](const Corners& corners) { return corners.size() == 3; };
  for (const Corners& corners : polygons) {
    if (triangle(corners)) {
      mesh.faces.push_back({corners[0], corners[1], corners[2]});
      continue;
    }
    const std::vector<Face> cut = cutter.cut(corners, draws).value();
    mesh.faces.insert(mesh.faces.end(), cut.begin(), cut.end());
  }
  if (!std::all_of(polygons.begin(), polygons.end(), triangle)) mesh.polygons = std::move(polygons);
  return mesh;
}

}  // namespace touchstone::catalogue
