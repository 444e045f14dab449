// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/exact_transform.h"

#include <gmpxx.h>

#include <cmath>
#include <cstddef>

namespace touchstone::audit::meshes {
namespace {

using Row = std::array<double, 4>;

mpq_class dot(const Row& row, double x, double y, double z, double w) {
  return mpq_class(row[0]) * x + mpq_class(row[1]) * y + mpq_class(row[2]) * z + mpq_class(row[3]) * w;
}

/// True if the number is a double, which is then stored.
bool stored(const mpq_class& exact, double& to) {
  to = exact.get_d();  // truncated, unless it is a double
  return std::isfinite(to) && mpq_class(to) == exact;
}

}  // namespace

std::optional<ExactTransform> composed(const ExactTransform& outer, const ExactTransform& inner) {
  const ExactTransform identity;
  if (outer == identity) return inner;
  if (inner == identity) return outer;
  const auto& [x, y, z] = inner.rows;
  ExactTransform made;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (!stored(dot(outer.rows[i], x[j], y[j], z[j], j == 3 ? 1 : 0), made.rows[i][j])) return std::nullopt;
    }
  }
  return made;
}

bool mirrors(const ExactTransform& transform) {
  const auto &x = transform.rows[0], &y = transform.rows[1], &z = transform.rows[2];
  const auto minor = [&](std::size_t i, std::size_t j) {
    return mpq_class(mpq_class(y[i]) * z[j] - mpq_class(y[j]) * z[i]);
  };
  return sgn(mpq_class(minor(1, 2) * x[0] - minor(0, 2) * x[1] + minor(0, 1) * x[2])) < 0;
}

std::optional<Point3d> image(const ExactTransform& transform, const Point3d& point) {
  std::array<double, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!stored(dot(transform.rows[i], point.x, point.y, point.z, 1), found[i])) return std::nullopt;
  }
  return Point3d{found[0], found[1], found[2]};
}

}  // namespace touchstone::audit::meshes
