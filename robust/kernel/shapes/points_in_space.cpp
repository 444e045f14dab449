// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/shapes/points_in_space.h"

namespace touchstone::robust::kernel {
namespace {

template <class Visit>
void for_each_coordinate(const std::vector<Point3d>& points, const Visit& visit) {
  for (const Point3d& p : points) visit(p.x), visit(p.y), visit(p.z);
}

/// lost: not 0 if a number does not fit.
ScaledPoints<std::int64_t> on_lattice(const std::vector<Point3d>& points, std::uint64_t& lost) {
  int top = 1;
  for_each_coordinate(
      points, [&](double x) { top = std::max(top, static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff)); });
  lost = top == 0x7ff;
  const auto placed = [&](double x) { return placed_on_lattice(std::bit_cast<std::uint64_t>(x), top, lost); };
  ScaledPoints<std::int64_t> found{{}, top - 1075 - lattice_spare};
  found.at.reserve(points.size());
  for (const Point3d& p : points) found.at.push_back({placed(p.x), placed(p.y), placed(p.z)});
  return found;
}

}  // namespace

std::optional<ScaledPoints<std::int64_t>> lattice_of(const Polygon3d& polygon) {
  std::uint64_t lost = 0;
  auto points = on_lattice(polygon.vertices, lost);
  if (lost != 0) return std::nullopt;
  return points;
}

std::vector<Point3<std::int64_t>> cut_to_lattice(const std::vector<Point3d>& points) {
  std::uint64_t lost = 0;
  return on_lattice(points, lost).at;
}

ScaledPoints<mpz_class> integers_of(const Polygon3d& polygon) {
  int low = INT_MAX;
  for_each_coordinate(polygon.vertices, [&](double x) {
    const Decoded part = decode(x);
    if (part.magnitude != 0) low = std::min(low, part.exponent);
  });
  if (low == INT_MAX) low = 0;
  const auto integer = [low](double x) {
    const Decoded part = decode(x);
    return part.magnitude == 0 ? mpz_class(0) : scaled(part, part.exponent - low);
  };
  ScaledPoints<mpz_class> points{{}, low};
  points.at.reserve(polygon.size());
  for (const Point3d& p : polygon.vertices) points.at.push_back({integer(p.x), integer(p.y), integer(p.z)});
  return points;
}

}  // namespace touchstone::robust::kernel
