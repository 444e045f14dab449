// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/rays.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/strict_math.h"

/// Intersections of segments, rays and triangles in space, by exact signs of determinants, without division.
namespace touchstone::robust::kernel {

/// The dimension of the common part, -1 if it is empty. Triangles and segments may be degenerate. For numbers on a
/// lattice, one for each axis; empty if they do not fit.
std::optional<int> common_dimension_on_lattice(const Triangle3d& a, const Triangle3d& b);
std::optional<int> common_dimension_on_lattice(const Segment3d& segment, const Triangle3d& triangle);
std::optional<int> common_dimension_on_lattice(const Ray3d& ray, const Triangle3d& triangle);

/// The same for all finite numbers.
int common_dimension_in_integers(const Triangle3d& a, const Triangle3d& b);
int common_dimension_in_integers(const Segment3d& segment, const Triangle3d& triangle);
int common_dimension_in_integers(const Ray3d& ray, const Triangle3d& triangle);

/// Uses the lattice if it suffices, otherwise integers.
inline int common_dimension(const Triangle3d& a, const Triangle3d& b) {
  const std::optional<int> found = common_dimension_on_lattice(a, b);
  return found ? *found : common_dimension_in_integers(a, b);
}

}  // namespace touchstone::robust::kernel
