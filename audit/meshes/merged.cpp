// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/merged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace touchstone::audit {
namespace {

std::vector<Index> places(std::size_t count) {
  std::vector<Index> all(count);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// For each vertex the first one at its position.
std::vector<Index> first_in_position(const std::vector<Point3d>& vertices) {
  const auto key = [&](Index v) { return std::tie(vertices[v].x, vertices[v].y, vertices[v].z); };
  std::vector<Index> sorted = places(vertices.size()), first(vertices.size());
  std::sort(sorted.begin(), sorted.end(),
            [&](Index v, Index w) { return key(v) < key(w) || (key(v) == key(w) && v < w); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool same = i > 0 && key(sorted[i - 1]) == key(sorted[i]);
    first[sorted[i]] = same ? first[sorted[i - 1]] : sorted[i];
  }
  return first;
}

double distance(const Point3d& p, const Point3d& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z); }

Point3d least_corner(const std::vector<Point3d>& vertices) {
  Point3d least = vertices[0];
  for (const Point3d& p : vertices) least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
  return least;
}

/// A vertex in the cell of a grid that contains it.
struct Held {
  std::array<std::int64_t, 3> cell;
  Index vertex;
  bool operator<(const Held& other) const { return std::tie(cell, vertex) < std::tie(other.cell, other.vertex); }
};

/// The cells are at least twice as wide as `reach` and at most 10^12 in a row, so that a rounded quotient is off by far
/// less than half a cell: two vertices nearer than `reach` are in one cell or in adjacent ones.
std::vector<Held> held_by_grid(const std::vector<Point3d>& vertices, double reach, double size) {
  const double width = std::max(2 * reach, 1e-12 * size);
  const Point3d least = least_corner(vertices);
  const auto cell = [&](double x, double from) { return static_cast<std::int64_t>(std::floor((x - from) / width)); };
  const std::vector<Index> first = first_in_position(vertices);
  std::vector<Held> held;
  for (Index v = 0; v < vertices.size(); ++v) {
    const Point3d& p = vertices[v];
    if (first[v] == v) held.push_back({{cell(p.x, least.x), cell(p.y, least.y), cell(p.z, least.z)}, v});
  }
  std::sort(held.begin(), held.end());
  return held;
}

Index root_of(std::vector<Index>& into, Index v) {
  while (into[v] != v) v = into[v] = into[into[v]];
  return v;
}

}  // namespace

double size_of(const std::vector<Point3d>& vertices) {
  if (vertices.empty()) return 0;
  const Point3d least = least_corner(vertices);
  double longest = 0;
  for (const Point3d& p : vertices) longest = std::max({longest, p.x - least.x, p.y - least.y, p.z - least.z});
  return longest;
}

void each_near_pair(const std::vector<Point3d>& vertices, double tolerance, const VisitPair& visit) {
  const double size = size_of(vertices), reach = tolerance * size;
  if (!(reach > 0)) return;
  if (!std::isfinite(size)) {
    std::vector<Point3d> quarter;
    for (const Point3d& p : vertices) quarter.push_back({p.x / 4, p.y / 4, p.z / 4});
    return each_near_pair(quarter, tolerance, [&](Index v, Index w, double apart) { visit(v, w, 4 * apart); });
  }
  const std::vector<Held> held = held_by_grid(vertices, reach, size);
  const auto compare = [&](const Held& one, const Held& other) {
    const double apart = distance(vertices[one.vertex], vertices[other.vertex]);
    if (apart < reach) visit(std::min(one.vertex, other.vertex), std::max(one.vertex, other.vertex), apart);
  };
  constexpr std::array<std::pair<int, int>, 4> rows_behind{{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
  for (auto one = held.begin(); one != held.end(); ++one) {
    const auto& [i, j, k] = one->cell;
    for (auto other = one + 1; other != held.end() && other->cell <= std::array{i, j, k + 1}; ++other)
      compare(*one, *other);
    for (const auto& [di, dj] : rows_behind) {
      const std::array last{i + di, j + dj, k + 1};
      auto other = std::lower_bound(one + 1, held.end(), Held{{i + di, j + dj, k - 1}, 0});
      for (; other != held.end() && other->cell <= last; ++other) compare(*one, *other);
    }
  }
}

Merging merging_of(const std::vector<Point3d>& vertices, double tolerance) {
  Merging result{first_in_position(vertices)};
  each_near_pair(vertices, tolerance, [&](Index v, Index w, double) {
    const auto [low, high] = std::minmax({root_of(result.into, v), root_of(result.into, w)});
    result.into[high] = low;
  });
  for (Index v = 0; v < vertices.size(); ++v) {
    const Index root = root_of(result.into, v);
    result.into[v] = root;
    if (root == v) continue;
    ++result.merged;
    result.largest = std::max(result.largest, distance(vertices[v], vertices[root]));
  }
  return result;
}

std::vector<std::vector<Index>> faces_after(const std::vector<std::vector<Index>>& faces, const Merging& merging) {
  std::vector<std::vector<Index>> result;
  result.reserve(faces.size());
  for (const std::vector<Index>& face : faces) {
    std::vector<Index>& corners = result.emplace_back();
    for (const Index v : face)
      if (corners.empty() || corners.back() != merging.into[v]) corners.push_back(merging.into[v]);
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() < 3) corners.clear();
  }
  return result;
}

}  // namespace touchstone::audit
