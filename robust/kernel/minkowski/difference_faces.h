// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/sized.h"

namespace touchstone::robust::kernel {

/// A vertex of a and one of b: the displacement between them is a point of the Minkowski difference of a and b.
struct Corners {
  Index of_a, of_b;
  friend bool operator==(const Corners&, const Corners&) = default;
};

/// The distinct vertices of one mesh among the corners, up to three.
struct Used {
  std::array<Index, 3> at{};
  std::size_t count = 0;

  bool has(Index i) const { return std::find(at.begin(), at.begin() + count, i) != at.begin() + count; }
  bool add(Index i) {
    if (has(i)) return true;
    if (count == at.size()) return false;
    at[count++] = i;
    return true;
  }
};

/// True if all vertices but the used ones are certainly on the side of these where the normal points.
template <class Normal>
bool alone(const std::vector<Point3d>& points, const Used& used, const Normal& normal) {
  const Point3d& first = points[used.at[0]];
  for (Index i = 0; i < points.size(); ++i)
    if (!dot(normal, filters::sized_between(first, points[i])).positive() && !used.has(i)) return false;
  return true;
}

bool all_moderate(const Meshd& mesh);

/// The vertex that is lowest along n, but for rounding.
Index lowest(const std::vector<Point3d>& points, const Vector3d& n);

/// An enclosure of the distance of a plane, or of a height along a normal: height / sqrt(square).
///
/// The exact height is in [low, high], and the exact square within its error. The sum with the error, the root, the
/// quotient and the last product are off by 2^-52 of themselves each, in every mode; 2^-40 is taken for all. Not proved
/// by machine.
struct DistanceRange {
  double least, most;

  template <int k>
  DistanceRange(double low, double high, const filters::Sized<k>& square) {
    const double shortest = square.value - square.error(), longest = square.value + square.error();
    most = shortest > 0 ? high / std::sqrt(shortest) * (1 + 0x1p-40) : std::numeric_limits<double>::infinity();
    least = low > 0 && longest > 0 ? low / std::sqrt(longest) * (1 - 0x1p-40) : 0;
  }
};

/// Three corners whose displacements from a to b turn counter-clockwise, seen from where their plane's normal points.
using DifferenceFace = std::array<Corners, 3>;

/// If the origin certainly lies inside the Minkowski difference b - a: triangles, whose planes do not contain the
/// origin, among which each plane is that bounds the difference and is nearest to the origin. Other planes may be among
/// them, too, if they seem to bound it and to be as near. Nothing if the numbers are not `moderate`, or do not tell.
std::optional<std::vector<DifferenceFace>> nearest_difference_faces(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
