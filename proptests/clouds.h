// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polyhedra.h"

/// Clouds of thousands of points in space, and the definition of their hulls.
namespace touchstone::proptests {

__extension__ typedef __int128 Int128;

/// The definition on integers below 2^30, for clouds that the oracle would take too long for: as convex_hull_defect,
/// which says why that is enough.
inline bool is_hull(const std::vector<Point3d>& points, const std::vector<Face>& faces) {
  using IntegerPoint = std::array<Int128, 3>;
  const auto minus = [&](Index a, Index b) {
    const auto part = [](double p, double q) { return static_cast<Int128>(p) - static_cast<Int128>(q); };
    const Point3d &p = points[a], &q = points[b];
    return IntegerPoint{part(p.x, q.x), part(p.y, q.y), part(p.z, q.z)};
  };
  const auto dot = [](const IntegerPoint& v, const IntegerPoint& w) { return v[0] * w[0] + v[1] * w[1] + v[2] * w[2]; };
  const auto cross = [](const IntegerPoint& v, const IntegerPoint& w) {
    return IntegerPoint{v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
  };
  std::set<std::pair<Index, Index>> edges;
  std::map<Index, std::vector<IntegerPoint>> normals;
  for (const Face& f : faces) {
    for (const auto& edge : {std::pair{f.a, f.b}, {f.b, f.c}, {f.c, f.a}})
      if (!edges.insert(edge).second) return false;
    const IntegerPoint n = cross(minus(f.b, f.a), minus(f.c, f.a));
    for (const Index corner : {f.a, f.b, f.c}) normals[corner].push_back(n);
    bool below = false;
    for (Index p = 0; p < points.size(); ++p) {
      const Int128 height = dot(n, minus(p, f.a));
      if (height > 0) return false;
      below = below || height < 0;
    }
    if (!below) return false;  // no area either
  }
  for (const auto& [from, to] : edges)
    if (edges.count({to, from}) != 1) return false;
  for (const auto& [corner, around] : normals) {
    bool extreme = false;
    for (std::size_t i = 2; i < around.size() && !extreme; ++i)
      for (std::size_t k = 1; k < i; ++k) extreme = extreme || dot(cross(around[0], around[k]), around[i]) != 0;
    if (!extreme) return false;
  }
  std::set<std::array<double, 3>> places;
  for (const auto& [corner, around] : normals) places.insert({points[corner].x, points[corner].y, points[corner].z});
  return places.size() == normals.size();
}

/// Integers of `bits` bits: in a box, in a ball, on a paraboloid, in clusters, on a small grid, on few planes.
inline std::vector<Point3d> cloud(int shape, std::size_t count, int bits) {
  std::mt19937_64 next(static_cast<std::uint64_t>(shape));
  const auto below = [&next](double n) { return std::floor(static_cast<double>(next() >> 11) * 0x1p-53 * n); };
  const double size = std::ldexp(1, bits);
  std::vector<Point3d> points;
  while (points.size() < count) {
    const double x = below(size) - size / 2, y = below(size) - size / 2, z = below(size) - size / 2;
    const double root = std::floor(std::sqrt(size)), u = std::fmod(x, root), v = std::fmod(y, root);
    switch (shape) {
      case 0: points.push_back({x, y, z}); break;
      case 1:
        if (x * x + y * y + z * z < size * size / 4) points.push_back({x, y, z});
        break;
      case 2: points.push_back({u, v, u * u + v * v}); break;
      case 3:
        points.push_back({std::floor(x / 99) + (z > 0 ? size : 0), std::floor(y / 99), std::floor(z / 99)});
        break;
      case 4: points.push_back({below(12), below(12), below(12)}); break;
      case 5: points.push_back({u, v, below(2) == 1 ? u + v : root + root - u}); break;
      default: points.push_back({u, v, u - v + below(2)});  // a leaf
    }
  }
  return points;
}

/// Those that other programs were tested with: quickhull3d's in the folder hull/quickhull3d below TOUCHSTONE_DATA, or
/// below ../shared/data, with their names. None where they are not there.
inline std::vector<std::pair<std::string, std::vector<Point3d>>> clouds_from_elsewhere() {
  const char* given = std::getenv("TOUCHSTONE_DATA");
  const std::filesystem::path folder =
      std::filesystem::path(given == nullptr ? "../shared/data" : given) / "hull/quickhull3d";
  std::vector<std::pair<std::string, std::vector<Point3d>>> clouds;
  std::error_code missing;
  for (const auto& file : std::filesystem::directory_iterator(folder, missing)) {
    if (file.path().extension() != ".json") continue;
    std::ifstream in(file.path());
    std::vector<Point3d> points;
    for (const auto& p : nlohmann::json::parse(in))
      points.push_back({p[0].get<double>(), p[1].get<double>(), p[2].get<double>()});
    clouds.emplace_back(file.path().filename(), std::move(points));
  }
  return clouds;
}

}  // namespace touchstone::proptests
