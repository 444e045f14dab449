// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

#include "geometry/polyhedra.h"
#include "geometry/rays.h"
#include "robust/kernel/filters/processor.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/kernel/machine/parallel.h"

namespace touchstone::robust::structures {

/// The boxes around the faces of a valid mesh, in a tree of eight children a node.
///
/// Boxes are rounded to float, to nearest, whatever the host's environment is when the tree is made, and compared like
/// that: rounding is monotone, and so is taking the least numbers for 0, so boxes that meet still do. Faces are in the
/// order of a space-filling curve; the order makes boxes small, and no answer depends on it.
class FaceTree {
 public:
  explicit FaceTree(const Meshd& mesh);
  /// A tree of some faces; there is at least one.
  FaceTree(const Meshd& mesh, std::vector<Index> faces);

  /// Returns whether `wanted` is true for a face here and one there, by their indices in the meshes, whose boxes meet.
  /// Stops at the first; on several threads, which call `wanted` at the same time, soon after one.
  template <class Wanted>
  bool any_pair(const FaceTree& other, const Wanted& wanted, std::size_t threads = 1) const {
    const NodePair top{levels_.size() - 1, 0, other.levels_.size() - 1, 0};
    // One thread alone often finds a pair sooner than others begin.
    std::size_t left = threads <= 1 ? std::numeric_limits<std::size_t>::max() : 4096;
    const bool soon = any_pair(top, other, wanted, left);
    if (left > 0) return soon;
    std::vector<NodePair> pairs{top}, below;
    for (int level = 0; level < 12 && pairs.size() < 64 * threads; ++level, pairs.swap(below)) {
      below.clear();
      const auto keep = [&below](const NodePair& pair) {
        below.push_back(pair);
        return false;
      };
      for (const NodePair& pair : pairs) pair.of_faces() ? keep(pair) : any_below(pair, other, keep);
    }
    std::atomic<bool> found{false};
    in_parallel(threads, pairs.size(), [&](std::size_t n) {
      std::size_t all = std::numeric_limits<std::size_t>::max();
      if (any_pair(pairs[n], other, [&](Index f, Index g) { return found || wanted(f, g); }, all)) found = true;
    });
    return found;
  }

  /// Returns whether `wanted` is true for a face whose box meets the ray to +x. Stops at the first. Call while a
  /// kernel::ControlWord is in scope: the point is rounded as the boxes were.
  template <class Wanted>
  bool any_along_x(const Point3d& p, const Wanted& wanted) const {
    const std::array at{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    return any_along_x(levels_.size() - 1, 0, at, wanted);
  }

  /// From the first to the last t at which a ray can be in a face's box, or less and more; in lengths of the direction
  /// times one power of two for all faces.
  struct Stay {
    float first = 0, last = endless;
    bool begins() const { return first <= last; }
  };

  /// Returns whether wanted(index, stay) is true for a face that the ray can meet, or for one of some others, in any
  /// order; stay() is the face's Stay. Stops at the first. Call while a kernel::ControlWord is in scope.
  template <class Wanted>
  bool any_along(const Ray3d& ray, const Wanted& wanted) const {
    const Slabs slabs(ray, greatest());
    if (!slabs.moderate) {
      const auto whole = [] { return Stay(); };
      return std::any_of(order_.begin(), order_.end(), [&](Index face) { return wanted(face, whole); });
    }
    struct Node {
      std::size_t above, i;  // one more than a level, a node's index
    };
    std::array<Node, 96> left;  // eleven levels, of each at most seven besides the one that is opened
    std::size_t size = 0;
    left[size++] = {levels_.size(), 0};
    while (size > 0) {
      const Node node = left[--size];
      const Block& block = levels_[node.above - 1][node.i];
      for (unsigned met = block.lanes_on(slabs); met != 0; met &= met - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(met)), child = 8 * node.i + lane;
        if (node.above > 1) left[size++] = {node.above - 1, child};
        else if (wanted(order_[child], [&] { return block.stay(slabs, lane); })) return true;
      }
    }
    return false;
  }

  /// The same for one question, without a tree: wanted is called for all faces of a mesh, the last one first, and a
  /// Stay that ends before it begins says that the ray does not meet the face.
  template <class Wanted>
  static bool any_of_all(const Meshd& mesh, const Ray3d& ray, const Wanted& wanted) {
    std::optional<Slabs> slabs;
    for (auto face = static_cast<Index>(mesh.faces.size()); face-- > 0;) {
      const auto stay = [&] {
        if (!slabs) slabs.emplace(ray, greatest_of(mesh));
        return slabs->moderate ? stay_of(mesh.faces[face], mesh, *slabs) : Stay();
      };
      if (wanted(face, stay)) return true;
    }
    return false;
  }

  /// Calls visit(index) for each face that may be nearest to a point, and for some others; visit returns an upper bound
  /// of the squared distance from the surface as far as it is known, and a face whose box is farther than that is left
  /// out. Call while a kernel::ControlWord is in scope.
  template <class Visit>
  void nearest(const Point3d& p, const Visit& visit) const {
    const Gaps gaps(p, greatest());
    if (!gaps.moderate) {
      for (const Index face : order_) visit(face);
      return;
    }
    least_first([&gaps](const Block& block) { return block.squares(gaps); }, std::numeric_limits<double>::infinity(),
                visit);
  }

  /// Calls visit(index) for each face that a ball can meet whose center moves from the ray's origin by its direction,
  /// which may be 0, and for some others, for the most part in the order in which it can; visit returns the t of the
  /// first contact that is known, rounded to nearest, or 1, and a face that is not met by then is left out. Call while
  /// a kernel::ControlWord is in scope.
  template <class Visit>
  void on_way(const Ray3d& way, double radius, const Visit& visit) const {
    const Slabs slabs(way, greatest(), static_cast<float>(radius));
    if (!slabs.moderate || slabs.exponent < -900 || slabs.exponent > 900) {
      for (const Index face : order_) visit(face);
      return;
    }
    // A first t that is not 0 is above 2^-90 here, so that no t that is compared with it was subnormal.
    const auto in_slabs = [&slabs](double t) { return std::scalbn(t * (1 + 0x1p-50), slabs.exponent); };
    least_first([&slabs](const Block& block) { return block.firsts(slabs); }, in_slabs(1),
                [&](Index face) { return in_slabs(visit(face)); });
  }

 private:
  static constexpr float endless = 0x1p126F;

  /// keys(block): a number for each box, NaN to leave it out, that is no greater than those of what is in it. Visits
  /// faces of least numbers first, as long as these do not exceed the bound that visit returns.
  template <class Keys, class Visit>
  void least_first(const Keys& keys, double bound, const Visit& visit) const {
    struct Node {
      std::size_t above, i;
      float key;
    };
    std::array<Node, 96> left;  // as above, and the faces of the last; the least is opened first
    std::size_t size = 0;
    left[size++] = {levels_.size(), 0, 0};
    while (size > 0) {
      const Node node = left[--size];
      if (node.key > bound) continue;
      if (node.above == 0) {
        bound = visit(order_[node.i]);
        continue;
      }
      const std::array<float, 8> found = keys(levels_[node.above - 1][node.i]);
      const std::size_t first = size;
      for (std::size_t lane = 0; lane < 8; ++lane) {
        if (!(found[lane] <= bound)) continue;  // a NaN
        std::size_t place = size++;
        for (; place > first && left[place - 1].key < found[lane]; --place) left[place] = left[place - 1];
        left[place] = {node.above - 1, 8 * node.i + lane, found[lane]};
      }
    }
  }

  /// A ray in floats, and what is computed of a box on each axis: the t at which the ray is past `first`, the bound of
  /// the box that it comes to first, is (first - from) inverse, and (last - until) inverse that at which it leaves.
  ///
  /// Let u = 2^-24, and M be the greatest magnitude of a coordinate of any box and of the origin, as floats. The
  /// direction is scaled by a power of two so that its greatest coordinate is between 1 and 2. On an axis where the ray
  /// rises, `from` is the origin o plus 16 u M and `until` o less 16 u M, so that with the bounds L and H of a face,
  /// exact, the first difference is at most L - o - 16 u M + 6.1 u M: o, `from` and the difference are rounded to
  /// nearest, and so was L. A direction, its reciprocal and the product, each rounded, are off by 3.1 u of their value,
  /// and L - o is at most 2.1 M where both are on the ray: so the first t as computed is at most the exact one, and at
  /// most 0 where that is. The last t as computed is at least the exact one likewise, where that is not negative. A
  /// direction below 2^-40 is taken for 2^-40: in a box t is at most 2.1 M, and the ray has moved there by less than
  /// 2^-38 M; so the first t is negative and the last at least 2^16 M. Hence no box that the ray meets is missed;
  /// nothing overflows, and what underflows is a first t near 0. Not proved by machine.
  ///
  /// A ball of radius R around the point on the ray meets what is in a box no sooner than the point meets the box that
  /// is larger by R on each side. Let M be at least R too; then 16 u M are 32 u M, and `from` is o plus R and that. R
  /// as a float, that sum, `from` and the difference, which is at most 3.2 M, are off by no more than 9.5 u M together:
  /// the first difference is at most L - R - o - 22 u M, of which 3.1 u of its value is less than 10 u M. So a first t
  /// that is not 0 is at least the quotient of 12 u M and 2, as long as M is 2^-60 or more. A direction of 0 is below
  /// 2^-40.
  struct Slabs {
    std::array<float, 3> from, until, inverse;
    std::array<bool, 3> falls;
    int exponent;   ///< t in lengths of the direction is multiplied by 2^exponent
    bool moderate;  ///< M is between 2^-60 and 2^60

    Slabs(const Ray3d& ray, float greatest, float radius = 0);
  };

  /// A point in floats, a little more and a little less on each axis.
  ///
  /// With u and M as for Slabs, s = 16 u M, and the bound L of a face, exact, L - p is at least the float of L -
  /// (p + s) plus 10.8 u M: p, p + s, L and the difference are rounded to nearest, which is 5.2 u M. Where that float g
  /// is positive, it is at most 2.1 M, so that the square of the exact gap exceeds g^2 by 21.6 u M g > 10 u g^2 and
  /// by (10.8 u M)^2; three squares and two sums, rounded, add at most 5.1 u of the sum, and what underflows, 2^-148,
  /// which is less than (10.8 u M)^2 for M >= 2^-50. So no square as computed exceeds that of the exact distance from
  /// the box. Not proved by machine.
  struct Gaps {
    std::array<float, 3> above, below;
    bool moderate;  ///< M is between 2^-50 and 2^60

    Gaps(const Point3d& p, float greatest);
  };

  float greatest() const;
  static float greatest_of(const Meshd& mesh);
  static Stay stay_of(const Face& face, const Meshd& mesh, const Slabs& slabs);

  /// Eight boxes; missing ones meet none.
  struct Block {
    std::array<std::array<float, 8>, 3> low, high;

    unsigned lanes_met_by(const Block& other, std::size_t i) const {
      return four_met_by(other, i, 0) | four_met_by(other, i, 4) << 4;
    }
    /// Those that the ray to +x meets.
    unsigned lanes_along_x(const std::array<float, 3>& p) const { return four_along_x(p, 0) | four_along_x(p, 4) << 4; }
    Stay stay(const Slabs& slabs, std::size_t lane) const {
      Stay found;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float first = (slabs.falls[axis] ? high : low)[axis][lane],
                    last = (slabs.falls[axis] ? low : high)[axis][lane];
        found.first = std::max(found.first, (first - slabs.from[axis]) * slabs.inverse[axis]);
        found.last = std::min(found.last, (last - slabs.until[axis]) * slabs.inverse[axis]);
      }
      return found;
    }
    unsigned lanes_on(const Slabs& slabs) const { return four_on(slabs, 0) | four_on(slabs, 4) << 4; }
    /// The first t of each box that the ray meets, or less; NaN for the others.
    std::array<float, 8> firsts(const Slabs& slabs) const {
      std::array<float, 8> found;
      for (std::size_t from : {0, 4}) {
        Four enter;
        const Found met = four_stays(slabs, from, enter);
        enter = reinterpret_cast<Four>(reinterpret_cast<Found>(enter) | ~met);
        std::memcpy(&found[from], &enter, sizeof enter);
      }
      return found;
    }
    /// The squared distance of a point from each box, or less; NaN for a missing one.
    std::array<float, 8> squares(const Gaps& gaps) const {
      std::array<float, 8> sums;
      four_squares(gaps, 0, sums), four_squares(gaps, 4, sums);
      return sums;
    }
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
    /// The greater of two, or a NaN if the second one is.
    static Four later(const Four& a, const Four& b) {
      const auto first = reinterpret_cast<Found>(a >= b);
      return reinterpret_cast<Four>((reinterpret_cast<Found>(a) & first) | (reinterpret_cast<Found>(b) & ~first));
    }
    void four_squares(const Gaps& gaps, std::size_t from, std::array<float, 8>& sums) const {
      const Four none{0, 0, 0, 0};
      Four sum = none;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Four least, most;
        std::memcpy(&least, &low[axis][from], sizeof least), std::memcpy(&most, &high[axis][from], sizeof most);
        const Four beyond = later(none, later(least - gaps.above[axis], gaps.below[axis] - most));
        sum += beyond * beyond;
      }
      std::memcpy(&sums[from], &sum, sizeof sum);
    }
    unsigned four_on(const Slabs& slabs, std::size_t from) const {
      Four enter;
      return kernel::processor::signs(four_stays(slabs, from, enter));
    }
    /// Which are met, and when they are entered; a missing box is entered at NaN.
    Found four_stays(const Slabs& slabs, std::size_t from, Four& enter) const {
      Four leave{-endless, -endless, -endless, -endless};
      enter = Four{0, 0, 0, 0};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Four first, last;
        std::memcpy(&first, &(slabs.falls[axis] ? high : low)[axis][from], sizeof first);
        std::memcpy(&last, &(slabs.falls[axis] ? low : high)[axis][from], sizeof last);
        enter = later(enter, (first - slabs.from[axis]) * slabs.inverse[axis]);
        leave = later(leave, (slabs.until[axis] - last) * slabs.inverse[axis]);
      }
      return reinterpret_cast<Found>(enter <= -leave);
    }
  };

  /// A node here and one there. Node i of a level has the children 8 i to 8 i + 7 of the one below; the nodes of level
  /// 0 are faces.
  struct NodePair {
    std::size_t level, i, other_level, j;
    bool of_faces() const { return level == 0 && other_level == 0; }
  };

  /// Opens the node of the higher level: returns whether visit(pair) is true for a child of it, and the other, whose
  /// boxes meet. Stops at the first.
  template <class Visit>
  bool any_below(const NodePair& pair, const FaceTree& other, const Visit& visit) const {
    const auto& [level, i, other_level, j] = pair;
    const bool here = level >= other_level;
    const Block& whole = here ? other.block(other_level, j) : block(level, i);
    const Block& parts = here ? levels_[level - 1][i] : other.levels_[other_level - 1][j];
    for (unsigned met = parts.lanes_met_by(whole, (here ? j : i) % 8); met != 0; met &= met - 1) {
      const std::size_t child = 8 * (here ? i : j) + static_cast<std::size_t>(std::countr_zero(met));
      if (visit(here ? NodePair{level - 1, child, other_level, j} : NodePair{level, i, other_level - 1, child}))
        return true;
    }
    return false;
  }
  /// Gives up, with true, after as many pairs as are `left`: then none is.
  template <class Wanted>
  bool any_pair(const NodePair& pair, const FaceTree& other, const Wanted& wanted, std::size_t& left) const {
    if (--left == 0) return true;
    if (pair.of_faces()) return wanted(order_[pair.i], other.order_[pair.j]);
    return any_below(pair, other, [&](const NodePair& below) { return any_pair(below, other, wanted, left); });
  }
  template <class Wanted>
  bool any_along_x(std::size_t level, std::size_t block, const std::array<float, 3>& p, const Wanted& wanted) const {
    for (unsigned met = levels_[level][block].lanes_along_x(p); met != 0; met &= met - 1) {
      const std::size_t child = 8 * block + static_cast<std::size_t>(std::countr_zero(met));
      if (level == 0 ? wanted(order_[child]) : any_along_x(level - 1, child, p, wanted)) return true;
    }
    return false;
  }
  const Block& block(std::size_t level, std::size_t i) const { return levels_[level][i / 8]; }
  void sort_faces(const Meshd& mesh);

  std::vector<Index> order_;                ///< the indices of the faces
  std::vector<std::vector<Block>> levels_;  ///< the boxes of the nodes, eight by eight
};

}  // namespace touchstone::robust::structures
