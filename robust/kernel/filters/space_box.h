// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/ordered_bits.h"

namespace touchstone::robust::kernel {

/// The double of which these are the ordered bits; 0.0 of both zeros.
inline double of_ordered_bits(std::int64_t ordered) {
  const std::int64_t sign = ordered >> 63;
  return std::bit_cast<double>((ordered + sign) ^ (sign & std::numeric_limits<std::int64_t>::max()));
}

/// A closed axis-aligned box, compared by the bits of its doubles.
struct SpaceBox {
  std::array<std::int64_t, 3> low, high;

  static SpaceBox around(const Point3d& p) {
    const std::array at{ordered_bits(p.x), ordered_bits(p.y), ordered_bits(p.z)};
    return {at, at};
  }
  static SpaceBox around(const Meshd& mesh, const Face& f) {
    return around(mesh.vertices[f.a]).with(around(mesh.vertices[f.b])).with(around(mesh.vertices[f.c]));
  }
  /// The box around the vertices that faces use; there is at least one.
  static SpaceBox around(const Meshd& mesh) {
    SpaceBox box = around(mesh, mesh.faces[0]);
    for (const Face& face : mesh.faces) box = box.with(around(mesh, face));
    return box;
  }

  SpaceBox with(const SpaceBox& other) const {
    SpaceBox both = *this;
    for (std::size_t i = 0; i < 3; ++i)
      both.low[i] = std::min(low[i], other.low[i]), both.high[i] = std::max(high[i], other.high[i]);
    return both;
  }
  bool meets(const SpaceBox& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (high[i] < other.low[i] || other.high[i] < low[i]) return false;
    return true;
  }
  /// True unless all of it is below the other along an axis.
  bool reaches(const SpaceBox& other) const {
    return high[0] >= other.low[0] && high[1] >= other.low[1] && high[2] >= other.low[2];
  }
};

}  // namespace touchstone::robust::kernel
