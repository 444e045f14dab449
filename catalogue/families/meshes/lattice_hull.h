// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/polyhedra.h"

namespace touchstone::catalogue {

/// A lattice point or vector.
using LatticePoint = std::array<std::int64_t, 3>;

inline LatticePoint minus(const LatticePoint& p, const LatticePoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline LatticePoint cross(const LatticePoint& v, const LatticePoint& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}
inline std::int64_t dot(const LatticePoint& v, const LatticePoint& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

/// The points, and triangles over those that are corners of their hull; no faces where all points lie in one plane.
/// Asks every plane through three points: for a hundred points, not for thousands. Coordinates of at most 14,000: the
/// product of two normals, below 3 (8 m^2)^2 for coordinates up to m, has to be a long.
Meshd lattice_hull(const std::vector<LatticePoint>& points);

}  // namespace touchstone::catalogue
