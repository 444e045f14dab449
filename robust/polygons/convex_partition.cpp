// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/convex_partition.h"

#include <algorithm>
#include <cstdint>

#include "robust/lines/orientation.h"
#include "robust/polygons/triangulate_polygon.h"

namespace touchstone::robust {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

/// The sides of all triangles: side 3 i + k goes from corner k of triangle i to the next one around its piece, which is
/// the triangle at first.
class Sides {
 public:
  Sides(const Polygon2d& polygon, const std::vector<std::vector<Index>>& triangles) : polygon_(polygon) {
    sides_.reserve(3 * triangles.size());
    for (const auto& corners : triangles) {
      const auto first = static_cast<std::uint32_t>(sides_.size());
      for (std::uint32_t k = 0; k < 3; ++k)
        sides_.push_back({corners[k], first + (k + 1) % 3, first + (k + 2) % 3, none, true});
    }
    pair_up();
  }

  /// Removes, one by one, every diagonal without which the angles at its ends stay convex or flat.
  void take_out_unneeded(Stage& latest) {
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      const std::uint32_t t = sides_[s].twin;
      if (t == none || !sides_[s].there) continue;
      const Side at_start = turn(sides_[s].previous, s, sides_[t].next, latest);
      if (at_start == Side::right || turn(sides_[t].previous, t, sides_[s].next, latest) == Side::right) continue;
      link(sides_[s].previous, sides_[t].next), link(sides_[t].previous, sides_[s].next);
      sides_[s].there = sides_[t].there = false;
    }
  }

  std::vector<std::vector<Index>> pieces() {
    std::vector<std::vector<Index>> found;
    for (std::uint32_t first = 0; first < sides_.size(); ++first) {
      if (!sides_[first].there) continue;
      found.emplace_back();
      for (std::uint32_t s = first; sides_[s].there; s = sides_[s].next) {
        found.back().push_back(sides_[s].from);
        sides_[s].there = false;
      }
    }
    return found;
  }

 private:
  struct OneSide {
    Index from;
    std::uint32_t next, previous, twin;  ///< twin: the same diagonal in the opposite direction
    bool there;
  };

  Index to(std::uint32_t s) const { return sides_[sides_[s].next].from; }

  /// Each diagonal is two sides. Sorting by ends brings them together.
  void pair_up() {
    std::vector<std::uint32_t> order;
    const auto lower = [&](std::uint32_t s) { return std::min(sides_[s].from, to(s)); };
    const auto upper = [&](std::uint32_t s) { return std::max(sides_[s].from, to(s)); };
    for (std::uint32_t s = 0; s < sides_.size(); ++s) order.push_back(s);
    std::sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
      return std::pair(std::pair(lower(s), upper(s)), s) < std::pair(std::pair(lower(t), upper(t)), t);
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      const std::uint32_t s = order[i - 1], t = order[i];
      if (lower(s) == lower(t) && upper(s) == upper(t)) sides_[s].twin = t, sides_[t].twin = s;
    }
  }

  /// The turn of the boundary at the start of side s, between the sides before and after it.
  Side turn(std::uint32_t before, std::uint32_t s, std::uint32_t after, Stage& latest) const {
    return stages::orientation::ask(polygon_[sides_[before].from], polygon_[sides_[s].from], polygon_[to(after)])
        .noting(latest);
  }

  void link(std::uint32_t s, std::uint32_t t) { sides_[s].next = t, sides_[t].previous = s; }

  const Polygon2d& polygon_;
  std::vector<OneSide> sides_;
};

}  // namespace

Decided<std::vector<std::vector<Index>>> stages::convex_partition::ask(const Polygon2d& polygon) {
  auto [triangles, latest] = triangulate_polygon::ask(polygon);
  Sides sides(polygon, triangles);
  sides.take_out_unneeded(latest);
  return {sides.pieces(), latest};
}

std::vector<std::vector<Index>> convex_partition(const Polygon2d& polygon) {
  return stages::convex_partition::ask(polygon).answer;
}

}  // namespace touchstone::robust
