// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/space.h"

namespace touchstone::audit::meshes {

/// An affine map: the first three entries of a row times the coordinates, plus the fourth, without rounding.
struct ExactTransform {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  friend bool operator==(const ExactTransform&, const ExactTransform&) = default;
};

/// First `inner`, then `outer`; nullopt if an entry of their product is not a double.
std::optional<ExactTransform> composed(const ExactTransform& outer, const ExactTransform& inner);

/// True if it turns right-handed corners into left-handed ones.
bool mirrors(const ExactTransform& transform);

/// The image of a point; nullopt if one of its coordinates is not a double.
std::optional<Point3d> image(const ExactTransform& transform, const Point3d& point);

}  // namespace touchstone::audit::meshes
