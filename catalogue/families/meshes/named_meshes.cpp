// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/named_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/lattice_hull.h"
#include "catalogue/families/space_draws.h"

namespace touchstone::catalogue {
namespace {

/// Twelve times the lattice points at squared distance 26 from the origin: 72, all of them corners. Most faces have
/// more than three corners, so that neighbouring triangles lie in one plane.
std::vector<LatticePoint> lattice_sphere() {
  std::vector<LatticePoint> points;
  for (std::int64_t x = -5; x <= 5; ++x) {
    for (std::int64_t y = -5; y <= 5; ++y) {
      for (std::int64_t z = -5; z <= 5; ++z) {
        if (x * x + y * y + z * z == 26) points.push_back({12 * x, 12 * y, 12 * z});
      }
    }
  }
  return points;
}

/// The corners of an octahedron whose sides are cut into 16 triangles each, moved onto a sphere and rounded to
/// multiples of 12. No two triangles of the hull lie in one plane.
std::vector<LatticePoint> geodesic() {
  std::vector<LatticePoint> points;
  for (std::int64_t x = -4; x <= 4; ++x) {
    for (std::int64_t y = -4; y <= 4; ++y) {
      for (std::int64_t z = -4; z <= 4; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) != 4) continue;
        const double distance = std::sqrt(static_cast<double>(x * x + y * y + z * z));
        const auto rounded = [distance](std::int64_t n) {
          return 12 * std::lround(1000 * static_cast<double>(n) / distance);
        };
        points.push_back({rounded(x), rounded(y), rounded(z)});
      }
    }
  }
  return points;
}

/// An oblique prism over a polygon of 32 corners, whose edges are the 32 lattice vectors without a common divisor of at
/// most 3 in each coordinate, twelve times as long: 30 triangles lie in each of two planes, in 32 others two.
std::vector<LatticePoint> prism() {
  std::vector<LatticePoint> edges;
  for (std::int64_t x = -3; x <= 3; ++x) {
    for (std::int64_t y = -3; y <= 3; ++y) {
      if (std::gcd(x, y) == 1) edges.push_back({12 * x, 12 * y, 0});
    }
  }
  const auto below = [](const LatticePoint& v) { return v[1] < 0 || (v[1] == 0 && v[0] < 0); };
  std::sort(edges.begin(), edges.end(), [below](const LatticePoint& v, const LatticePoint& w) {
    return below(v) != below(w) ? below(w) : cross(v, w)[2] > 0;
  });
  std::vector<LatticePoint> points;
  LatticePoint corner{0, 0, 0};
  for (const LatticePoint& edge : edges) {
    corner = {corner[0] + edge[0], corner[1] + edge[1], 0};
    points.push_back(corner);
    points.push_back({corner[0] + 36, corner[1] - 60, 240});
  }
  return points;
}

/// Each axis by its own power of two: beyond any lattice, and products that filters cannot bound.
Meshd stretched(Meshd mesh) {
  for (Point3d& p : mesh.vertices) p = scaled(p, 300, -170, -300);
  return mesh;
}

/// The outer cubes of a layer of five times five.
std::vector<LatticePoint> ring_of_cells() {
  std::vector<LatticePoint> cells;
  for (std::int64_t x = 0; x < 5; ++x) {
    for (std::int64_t y = 0; y < 5; ++y) {
      if (x == 0 || x == 4 || y == 0 || y == 4) cells.push_back({x, y, 0});
    }
  }
  return cells;
}

/// The 26 cubes around one.
std::vector<LatticePoint> cells_around_one() {
  std::vector<LatticePoint> cells;
  for (std::int64_t i = 0; i < 27; ++i) {
    if (i != 13) cells.push_back({i % 3, i / 3 % 3, i / 9});
  }
  return cells;
}

/// A row of 63 cubes, and one more above every other: a comb of 32 teeth.
std::vector<LatticePoint> comb_of_cells() {
  std::vector<LatticePoint> cells;
  for (std::int64_t x = 0; x < 63; ++x) {
    cells.push_back({x, 0, 0});
    if (x % 2 == 0) cells.push_back({x, 1, 0});
  }
  return cells;
}

/// Every vertex but each third one twice as far from the origin, so that the faces between have an edge or a corner
/// that goes inwards.
Meshd star(Meshd mesh) {
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    Point3d& p = mesh.vertices[i];
    if (i % 3 != 0) p = {2 * p.x, 2 * p.y, 2 * p.z};
  }
  return mesh;
}

}  // namespace

const std::vector<NamedMesh>& named_meshes() {
  static const std::vector<NamedMesh> all{{"lattice_sphere_72", lattice_hull(lattice_sphere())},
                                          {"geodesic_66", lattice_hull(geodesic())},
                                          {"prism_64", lattice_hull(prism())},
                                          {"stretched_72", stretched(lattice_hull(lattice_sphere()))}};
  return all;
}

const std::vector<NamedMesh>& named_solids() {
  static const std::vector<NamedMesh> all{{"ring_64", cube_surface(ring_of_cells())},
                                          {"hollow_64", cube_surface(cells_around_one())},
                                          {"star_66", star(lattice_hull(geodesic()))},
                                          {"stretched_star_66", stretched(star(lattice_hull(geodesic())))}};
  return all;
}

const std::vector<NamedMesh>& long_solids() {
  static const std::vector<NamedMesh> all{{"comb_384", cube_surface(comb_of_cells())}};
  return all;
}

}  // namespace touchstone::catalogue
