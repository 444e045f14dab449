// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "oracle/exact/solids/triangles.h"

/// Planes between the convex hulls of two lists of points, by exact linear programs.
namespace touchstone::oracle {

/// normal . p <= offset at all of a and >= offset at all of b, but not = at all points of both.
std::optional<WitnessPlane> plane_between(const std::vector<Point3<Integer>>& a, const std::vector<Point3<Integer>>& b);

/// normal . p > offset at all of a and < offset at all of b.
std::optional<WitnessPlane> plane_apart(const std::vector<Point3<Integer>>& a, const std::vector<Point3<Integer>>& b);

}  // namespace touchstone::oracle
