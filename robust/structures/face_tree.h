// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/processor.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

/// The boxes around the faces of a valid mesh, which must outlive it, in a tree of eight children a node.
///
/// Boxes are rounded to float, and compared like that: in every rounding mode, and even if the least numbers count as
/// 0, rounding is monotone, so boxes that meet still do. Faces are in the order of a space-filling curve; the order
/// makes boxes small, and no answer depends on it.
class FaceTree {
 public:
  explicit FaceTree(const Meshd& mesh);
  /// A tree of some faces; there is at least one.
  FaceTree(const Meshd& mesh, std::vector<Index> faces);

  /// Returns whether `wanted` is true for a face here and one there, by their indices in the meshes, whose boxes meet.
  /// Stops at the first.
  template <class Wanted>
  bool any_pair(const FaceTree& other, const Wanted& wanted) const {
    const int top = static_cast<int>(levels_.size()) - 1, other_top = static_cast<int>(other.levels_.size()) - 1;
    return any_pair(top, 0, other, other_top, 0, wanted);
  }

  /// Returns whether `wanted` is true for a face whose box meets the ray to +x. Stops at the first.
  template <class Wanted>
  bool any_along_x(const Point3d& p, const Wanted& wanted) const {
    return any_along_x(levels_.size() - 1, 0, {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                       wanted);
  }

 private:
  /// Eight boxes; missing ones meet none.
  struct Block {
    std::array<std::array<float, 8>, 3> low, high;

    unsigned lanes_met_by(const Block& other, std::size_t i) const {
      return four_met_by(other, i, 0) | four_met_by(other, i, 4) << 4;
    }
    /// Those that the ray to +x meets.
    unsigned lanes_along_x(const std::array<float, 3>& p) const { return four_along_x(p, 0) | four_along_x(p, 4) << 4; }
    void set(std::size_t lane, const std::array<float, 3>& least, const std::array<float, 3>& greatest) {
      for (std::size_t axis = 0; axis < 3; ++axis) low[axis][lane] = least[axis], high[axis][lane] = greatest[axis];
    }

   private:
    using Four = kernel::processor::FourFloats;
    using Found = kernel::processor::TwoBits;
    unsigned four_along_x(const std::array<float, 3>& p, std::size_t from) const {
      Four least, most;
      std::memcpy(&most, &high[0][from], sizeof most);
      Found met = reinterpret_cast<Found>(Four{p[0], p[0], p[0], p[0]} <= most);
      for (std::size_t axis = 1; axis < 3; ++axis) {
        std::memcpy(&least, &low[axis][from], sizeof least), std::memcpy(&most, &high[axis][from], sizeof most);
        const Four at{p[axis], p[axis], p[axis], p[axis]};
        met &= reinterpret_cast<Found>(at <= most) & reinterpret_cast<Found>(least <= at);
      }
      return kernel::processor::signs(met);
    }
    unsigned four_met_by(const Block& other, std::size_t i, std::size_t from) const {
      Found met = ~Found{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Four least, most;
        std::memcpy(&least, &low[axis][from], sizeof least), std::memcpy(&most, &high[axis][from], sizeof most);
        const float l = other.low[axis][i], m = other.high[axis][i];
        met &= reinterpret_cast<Found>(Four{l, l, l, l} <= most) & reinterpret_cast<Found>(least <= Four{m, m, m, m});
      }
      return kernel::processor::signs(met);
    }
  };

  /// Node i of a level has the children 8 i to 8 i + 7 of the one below; the nodes of level 0 are faces.
  template <class Wanted>
  bool any_pair(int level, std::size_t i, const FaceTree& other, int other_level, std::size_t j,
                const Wanted& wanted) const {
    if (level == 0 && other_level == 0) return wanted(order_[i], other.order_[j]);
    const bool here = level >= other_level;
    const Block& whole = here ? other.block(other_level, j) : block(level, i);
    const Block& parts = here ? levels_[static_cast<std::size_t>(level - 1)][i]
                              : other.levels_[static_cast<std::size_t>(other_level - 1)][j];
    for (unsigned met = parts.lanes_met_by(whole, (here ? j : i) % 8); met != 0; met &= met - 1) {
      const std::size_t child = 8 * (here ? i : j) + static_cast<std::size_t>(std::countr_zero(met));
      if (here ? any_pair(level - 1, child, other, other_level, j, wanted)
               : any_pair(level, i, other, other_level - 1, child, wanted))
        return true;
    }
    return false;
  }
  template <class Wanted>
  bool any_along_x(std::size_t level, std::size_t block, const std::array<float, 3>& p, const Wanted& wanted) const {
    for (unsigned met = levels_[level][block].lanes_along_x(p); met != 0; met &= met - 1) {
      const std::size_t child = 8 * block + static_cast<std::size_t>(std::countr_zero(met));
      if (level == 0 ? wanted(order_[child]) : any_along_x(level - 1, child, p, wanted)) return true;
    }
    return false;
  }
  const Block& block(int level, std::size_t i) const { return levels_[static_cast<std::size_t>(level)][i / 8]; }
  void sort_faces(const Meshd& mesh);

  std::vector<Index> order_;                ///< the indices of the faces
  std::vector<std::vector<Block>> levels_;  ///< the boxes of the nodes, eight by eight
};

}  // namespace touchstone::robust::structures
