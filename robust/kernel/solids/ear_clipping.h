// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include "robust/kernel/filters/strict_math.h"

/// Triangulation of one polygon in a plane, over any exact numbers.
namespace touchstone::robust::kernel {

/// Three corners of a polygon by number, in the polygon's orientation.
using CornerTriple = std::array<std::size_t, 3>;

/// True if the triangle a, i, b, where i follows a and b follows i, is an ear of the remaining corners: it turns to the
/// left, it contains no other corner except at the positions of its own, and if another corner coincides with i, no
/// edge there leads into it.
///
/// Ring: `turn(i, j, k)` is the sign of the turn at j, positive to the left; `same(i, j)` compares positions.
template <class Ring>
bool is_ear(const Ring& ring, const std::vector<std::size_t>& left, std::size_t at) {
  const std::size_t count = left.size(), a = left[(at + count - 1) % count], i = left[at], b = left[(at + 1) % count];
  if (ring.turn(a, i, b) <= 0) return false;
  const auto leads_into = [&](std::size_t to) { return ring.turn(a, i, to) > 0 && ring.turn(i, b, to) > 0; };
  for (std::size_t k = (at + 2) % count; left[k] != a; k = (k + 1) % count) {
    const std::size_t q = left[k];
    if (ring.same(q, a) || ring.same(q, b)) continue;
    if (ring.same(q, i)) {
      if (leads_into(left[(k + count - 1) % count]) || leads_into(left[(k + 1) % count])) return false;
    } else if (ring.turn(a, i, q) >= 0 && ring.turn(i, b, q) >= 0 && ring.turn(b, a, q) >= 0) {
      return false;
    }
  }
  return true;
}

/// Cuts off ears until a triangle is left (Meisters 1975); returns nullopt if there is no ear. For a polygon that
/// encloses an area on its left and does not cross itself the triangles are a valid triangulation
/// (geometry/polyhedra.h); this is not checked. Takes count^2 steps and more if few corners are ears.
template <class Ring>
std::optional<std::vector<CornerTriple>> clipped_ears(const Ring& ring, std::size_t count) {
  std::vector<std::size_t> left(count);
  std::iota(left.begin(), left.end(), std::size_t{0});
  std::vector<CornerTriple> triangles;
  for (std::size_t at = 0, passed = 0; left.size() > 3;) {
    if (is_ear(ring, left, at)) {
      triangles.push_back({left[(at + left.size() - 1) % left.size()], left[at], left[(at + 1) % left.size()]});
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
      passed = 0;
    } else {
      ++at;
      if (++passed == left.size()) return std::nullopt;
    }
    if (at >= left.size()) at = 0;
  }
  if (ring.turn(left[0], left[1], left[2]) <= 0) return std::nullopt;
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace touchstone::robust::kernel
