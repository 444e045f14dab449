// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/lowest_vertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "robust/kernel/shapes/points_in_space.h"

namespace touchstone::robust::kernel {
namespace {

/// The direction with its greatest coordinate in [1/2, 1): each off by less than 2^-52 of itself, or by 2^-1022.
Vector3d in_doubles(const Vector3<mpz_class>& direction) {
  std::int64_t x_place = 0, y_place = 0, z_place = 0;
  const double x = mpz_get_d_2exp(&x_place, direction.x.get_mpz_t());
  const double y = mpz_get_d_2exp(&y_place, direction.y.get_mpz_t());
  const double z = mpz_get_d_2exp(&z_place, direction.z.get_mpz_t());
  const std::int64_t top = std::max({x_place, y_place, z_place});
  const auto placed = [top](double part, std::int64_t place) {
    return place - top < -1000 ? 0.0 : std::ldexp(part, static_cast<int>(place - top));
  };
  return {placed(x, x_place), placed(y, y_place), placed(z, z_place)};
}

double size(const Vector3d& v) { return std::max({__builtin_fabs(v.x), __builtin_fabs(v.y), __builtin_fabs(v.z)}); }

/// The heights of points above the first, as doubles, and their error bound.
///
/// u = 2^-52 bounds a rounding in every mode. Let D be the greatest coordinate of p - first, as computed. The direction
/// is off by u of each coordinate, the difference by u, a product by u: three of at most D each are off by 9.1 u D, two
/// sums by 6.1 u D more: 16 u D = 2^-48 D, and twice that is taken. Numbers that underflow, or are read as zero, cost
/// at most 2^-1019 (1 + D). Guard: D in [2^-900, 2^1000], so that this is below 2^-100 of the bound, and nothing
/// overflows. Not proved by machine.
struct Heights {
  const Point3d& first;
  Vector3d direction;

  struct Height {
    double value, error;
  };
  Height of(const Point3d& p) const {
    const Vector3d displacement = p - first;
    const double most = size(displacement);
    if (!(most >= 0x1p-900 && most <= 0x1p1000)) return {0, 1};
    return {dot(direction, displacement), 0x1p-47 * most};
  }
};

}  // namespace

std::vector<Index> lowest_vertices(const std::vector<Point3d>& vertices, std::vector<Index> level,
                                   const Vector3<mpz_class>& direction) {
  const Heights heights{vertices[level[0]], in_doubles(direction)};
  double least = 0;
  Index lowest = level[0];
  std::vector<Index> near;
  for (Index i = 0; i < vertices.size(); ++i) {
    const auto [value, error] = heights.of(vertices[i]);
    if (value > error) continue;
    if (value < -error) {
      if (value < least) least = value, lowest = i;
    } else if (std::find(level.begin(), level.end(), i) == level.end()) {
      near.push_back(i);
    }
  }
  if (lowest != level[0]) return {lowest};
  if (near.empty()) return level;
  Polygon3d asked{{vertices[level[0]]}};
  for (const Index i : near) asked.vertices.push_back(vertices[i]);
  const auto points = integers_of(asked).at;
  mpz_class deepest = 0;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const mpz_class height = dot(direction, points[k + 1] - points[0]);
    if (sgn(height) == 0) level.push_back(near[k]);
    if (height < deepest) deepest = height, lowest = near[k];
  }
  if (sgn(deepest) < 0) return {lowest};
  return level;
}

}  // namespace touchstone::robust::kernel
