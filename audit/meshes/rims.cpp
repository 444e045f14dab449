// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/solids/polygon_faces.h"

namespace touchstone::audit::meshes {
namespace {

using Axis = double Point3d::*;
constexpr std::array<Axis, 3> axes{&Point3d::x, &Point3d::y, &Point3d::z};

bool collinear(const Point3d& p, const Point3d& q, const Point3d& r) {
  const robust::kernel::ControlWord ieee;
  for (std::size_t k = 0; k < 3; ++k) {
    const Axis u = axes[k], v = axes[(k + 1) % 3];
    const auto projected = [&](const Point3d& point) { return Point2d{point.*u, point.*v}; };
    if (robust::kernel::sign_of_turn(projected(p), projected(q), projected(r)) != 0) return false;
  }
  return true;
}

}  // namespace

std::vector<Rim> rims_of(const std::vector<EdgeOfFile>& open, const std::vector<Point3d>& vertices) {
  std::map<Index, Index> up;
  const auto root = [&up](Index v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  for (const EdgeOfFile& edge : open) {
    for (const Index v : {edge.low, edge.high}) up.emplace(v, v);
    const Index p = root(edge.low), q = root(edge.high);
    up[std::max(p, q)] = std::min(p, q);
  }
  std::map<Index, std::size_t> place;
  std::vector<Rim> rims;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto [at, fresh] = place.emplace(root(open[i].low), rims.size());
    if (fresh) rims.emplace_back();
    const Point3d &p = vertices[open[i].low], &q = vertices[open[i].high];
    rims[at->second].edges.push_back(i);
    rims[at->second].length += std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
  }
  return rims;
}

std::optional<TJunction> t_junction(const Rim& rim, const std::vector<EdgeOfFile>& open,
                                    const std::vector<Point3d>& vertices) {
  std::vector<Index> all;
  for (const std::size_t i : rim.edges) all.insert(all.end(), {open[i].low, open[i].high});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const Point3d& start = vertices[all[0]];
  const auto end = std::find_if(all.begin(), all.end(), [&](Index v) { return !(vertices[v] == start); });
  if (all.size() < 3 || end == all.end()) return std::nullopt;
  for (const Index v : all)
    if (!collinear(start, vertices[*end], vertices[v])) return std::nullopt;
  const Axis along =
      *std::find_if(axes.begin(), axes.end(), [&](Axis axis) { return vertices[*end].*axis != start.*axis; });
  std::stable_sort(all.begin(), all.end(), [&](Index v, Index w) { return vertices[v].*along < vertices[w].*along; });
  for (const std::size_t i : rim.edges) {
    const double one = vertices[open[i].low].*along, other = vertices[open[i].high].*along;
    const double low = std::min(one, other), high = std::max(one, other);
    const auto next =
        std::upper_bound(all.begin(), all.end(), low, [&](double x, Index v) { return x < vertices[v].*along; });
    if (next != all.end() && vertices[*next].*along < high) return TJunction{*next, open[i]};
  }
  return std::nullopt;
}

}  // namespace touchstone::audit::meshes
