// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/space.h"
#include "robust/kernel/integers/integers.h"

/// Lists of points of space over one power of two, like the single numbers of lattice.h and integers.h.
namespace touchstone::robust::kernel {

/// Point i is at[i] * 2^exponent exactly.
template <class Integer>
struct ScaledPoints {
  std::vector<Point3<Integer>> at;
  int exponent;
};

/// Coordinates below 2^61; empty if one has a set bit more than 61 places below the leading place of the largest
/// exponent.
std::optional<ScaledPoints<std::int64_t>> lattice_of(const Polygon3d& polygon);
/// The same for all finite numbers: digits that do not fit are cut off.
std::vector<Point3<std::int64_t>> cut_to_lattice(const std::vector<Point3d>& points);
ScaledPoints<mpz_class> integers_of(const Polygon3d& polygon);

}  // namespace touchstone::robust::kernel
