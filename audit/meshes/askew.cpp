// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/askew.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::audit {
namespace {

using Corners = std::vector<Index>;
using Axis = double Point3d::*;

/// The projection of a face: the other two coordinates, and whether it turns to the left in them.
struct Projection {
  Axis along, u, v;
  int sign;
};

Projection projection_of(const std::vector<Point3d>& vertices, const Corners& corners) {
  using P = Point3d;
  const Vector3d n = robust::ScaledRing(vertices, corners).normal;
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (z >= x && z >= y) return {&P::z, &P::x, &P::y, n.z < 0 ? -1 : 1};
  if (y >= x) return {&P::y, &P::z, &P::x, n.y < 0 ? -1 : 1};
  return {&P::x, &P::y, &P::z, n.x < 0 ? -1 : 1};
}

/// The corners of a face as a ring in the plane, for ear clipping.
struct Ring {
  std::vector<Point2d> points;
  int sign;

  Ring(const std::vector<Point3d>& vertices, const Corners& corners) {
    const Projection projected = projection_of(vertices, corners);
    for (const Index c : corners) points.push_back({vertices[c].*projected.u, vertices[c].*projected.v});
    sign = projected.sign;
  }
  int turn(std::size_t i, std::size_t j, std::size_t k) const {
    return sign * robust::kernel::sign_of_turn(points[i], points[j], points[k]);
  }
  bool same(std::size_t i, std::size_t j) const { return points[i] == points[j]; }
};

}  // namespace

std::optional<std::vector<Face>> cut_as_projected(const std::vector<Point3d>& vertices, const Corners& corners) {
  const Projection projected = projection_of(vertices, corners);
  Corners distinct = corners, local;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<Point3d> flat;
  for (const Index v : distinct) flat.push_back(vertices[v]), flat.back().*projected.along = 0;
  for (const Index v : corners)
    local.push_back(static_cast<Index>(std::lower_bound(distinct.begin(), distinct.end(), v) - distinct.begin()));
  auto cut = robust::kernel::cut_polygon(flat, local);
  if (std::holds_alternative<robust::kernel::PolygonDefect>(cut)) return std::nullopt;
  auto& triangles = std::get<std::vector<Face>>(cut);
  for (Face& f : triangles) f = {distinct[f.a], distinct[f.b], distinct[f.c]};
  return std::move(triangles);
}

std::optional<std::vector<Face>> cut_along_shortest(const std::vector<Point3d>& vertices, const Corners& corners) {
  const robust::kernel::ControlWord ieee;
  const Ring ring(vertices, corners);
  std::vector<std::size_t> left(corners.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<Face> triangles;
  while (left.size() > 3) {
    const std::size_t count = left.size();
    const auto before = [&](std::size_t at) { return corners[left[(at + count - 1) % count]]; };
    const auto after = [&](std::size_t at) { return corners[left[(at + 1) % count]]; };
    std::vector<std::pair<double, std::size_t>> diagonals;
    for (std::size_t at = 0; at < count; ++at) {
      const Vector3d d = vertices[after(at)] - vertices[before(at)];
      diagonals.emplace_back(std::hypot(d.x, d.y, d.z), at);
    }
    std::sort(diagonals.begin(), diagonals.end());
    const auto ear = std::find_if(diagonals.begin(), diagonals.end(), [&](const auto& diagonal) {
      return robust::kernel::is_ear(ring, left, diagonal.second);
    });
    if (ear == diagonals.end()) return std::nullopt;
    const std::size_t at = ear->second;
    triangles.push_back({before(at), corners[left[at]], after(at)});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
  }
  if (ring.turn(left[0], left[1], left[2]) <= 0) return std::nullopt;
  triangles.push_back({corners[left[0]], corners[left[1]], corners[left[2]]});
  return triangles;
}

std::vector<Face> cut_as_fan(const Corners& corners) {
  std::vector<Face> triangles;
  for (std::size_t k = 2; k < corners.size(); ++k) triangles.push_back({corners[0], corners[k - 1], corners[k]});
  return triangles;
}

}  // namespace touchstone::audit
