// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/vectors.h"

/// Filters of round convex solids, as robust/kernel/enclosed/round_solids.h has them for one question: a guess of the
/// nearest points, and certain signs that prove it. The signs are proved by machine from this text, whatever is
/// guessed (robust/proofs/lane_cores.v, lane_sphere_obb.v, lane_capsules.v).
namespace touchstone::robust::batch::isa {
namespace {

/// A guess, on which nothing depends but the time: the t_k that make way - sum t_k edge_k shortest, each in an
/// interval, into which it is `moved` last: of two segments between 0 and 1, of a box between -1 and 1. The foot of the
/// perpendicular along edge k is at t_k = foot_k + sum pull_kl t_l over the others.
template <std::size_t n, Lanes moved(Lanes)>
class Nearest {
 public:
  Nearest(const InSpace& way, const InSpace (&edges)[n]) {
    for (std::size_t k = 0; k < n; ++k) {
      const Lanes per_square = same(1) / dot(edges[k], edges[k]);
      foot_[k] = dot(way, edges[k]) * per_square;
      for (std::size_t i = 1; i < n; ++i) {
        const std::size_t l = (k + i) % n;
        pull_[k][l] = dot(edges[k], edges[l]) * (same(0) - per_square);
      }
    }
  }

  /// From a guess to a better one.
  void approach(Lanes (&t)[n], bool first) const {
    if constexpr (n == 3) {
      if (!first) step(t);
      slide(t);
    }
    slide(t);
  }

 private:
  /// Moves each t_k to the foot of the perpendicular along its edge: the nearest point at once where edges are at right
  /// angles.
  void slide(Lanes (&t)[n]) const {
    for (std::size_t k = 0; k < n; ++k) {
      Lanes foot = foot_[k];
      for (std::size_t i = 1; i < n; ++i) foot = multiply_add(pull_[k][(k + i) % n], t[(k + i) % n], foot);
      t[k] = moved(foot);
    }
  }

  /// Keeps each t_k that is at an end of its interval, and moves the others towards the point that makes the
  /// displacement shortest without regard to their intervals: straight there, or until the first of them is at an end.
  /// So the displacement does not become longer, and the guess does not go round in circles.
  ///
  /// `open` is 1 for those that move and 0 for the others. The equations t_k - sum pull_kl t_l = foot_k, or t_k itself
  /// at an end, are solved by cofactors. The part of the way to the end of its interval is (1 - t_k) / d where it moves
  /// up by d, and (1 + t_k) / -d where it moves down: 1 / |d| - t_k / d.
  void step(Lanes (&t)[n]) const {
    static_assert(n == 3);
    Lanes open[n], aim[n], pull[n][n];
    for (std::size_t k = 0; k < n; ++k) {
      open[k] = lesser((same(1) - magnitude(t[k])) * same(0x1p60), same(1));
      aim[k] = multiply_add(open[k], foot_[k] - t[k], t[k]);
      for (std::size_t i = 1; i < n; ++i) pull[k][(k + i) % n] = open[k] * pull_[k][(k + i) % n];
    }
    // Row k of the matrix has 1 and -pull; by symmetry a cofactor is 1 - pull pull, or pull + pull pull.
    const auto diagonal = [&pull](std::size_t i, std::size_t j) { return same(1) - pull[i][j] * pull[j][i]; };
    const auto beside = [&pull](std::size_t i, std::size_t j, std::size_t by) {
      return multiply_add(pull[i][by], pull[by][j], pull[i][j]);
    };
    const Lanes first = diagonal(1, 2), second = beside(1, 0, 2), third = beside(2, 0, 1);
    const Lanes per_determinant = same(1) / (first - pull[0][1] * second - pull[0][2] * third);
    const Lanes found[] = {first * aim[0] + beside(0, 1, 2) * aim[1] + beside(0, 2, 1) * aim[2],
                           second * aim[0] + diagonal(0, 2) * aim[1] + beside(1, 2, 0) * aim[2],
                           third * aim[0] + beside(2, 1, 0) * aim[1] + diagonal(0, 1) * aim[2]};
    Lanes part = same(1), moves[n];
    for (std::size_t k = 0; k < n; ++k) {
      moves[k] = open[k] * (found[k] * per_determinant - t[k]);
      const Lanes per_move = same(1) / moves[k];
      part = lesser(magnitude(per_move) - t[k] * per_move, part);  // a NaN, where it does not move, leaves the part
    }
    for (std::size_t k = 0; k < n; ++k) t[k] = moved(multiply_add(part, moves[k], t[k]));
  }

  Lanes foot_[n], pull_[n][n];
};

/// The least absolute error that is allowed for where all numbers are at most 2^250: of a product of three of them that
/// underflows, each has less.
constexpr double least = 0x1p-500;

/// Two cores: the displacements from a point of one to a point of the other are way - sum t_k edge_k, with t_k between
/// -1 and 1 where edges are symmetric, otherwise between 0 and 1. Coordinates of the way and of edges are numbers of
/// the input or differences of two.
template <std::size_t n, bool symmetric>
struct Cores {
  InSpace way, edges[n];

  /// The contact of the solids, `reach` being the sum of their radii, each of which is more than 0; t is the guess, any
  /// numbers, which are brought into their intervals before anything is concluded.
  ///
  /// A displacement shorter than the reach proves that they overlap, for any t_k in their intervals. If the way leads
  /// farther along some direction than the edges and the reach together, they are disjoint; the direction is the
  /// displacement as computed.
  ///
  /// In units of v, with `most` for the way's and the edges' magnitudes together on an axis: a displacement is off by
  /// n + 2 <= 5 times most, so its square with a product and two sums by 13 times the square of most, and that of the
  /// reach by 3 times itself. C = 16 v. Along the direction, the way goes through four operations and the edges through
  /// four and at most three differences: 7 times direction and most, C = 16 v again. The gap less its error is compared
  /// by its square: with one rounding, and 9 on the other side. C = 16 v.
  ///
  /// Nothing overflows where all magnitudes add up to 2^250 at most, which no infinite or NaN number does.
  Verdict contact(Lanes reach, Lanes (&t)[n]) const {
    constexpr int turns = n == 2 ? 1 : 4;
    InSpace most = magnitudes(way);
    for (const InSpace& edge : edges) most = most + magnitudes(edge);
    const Lanes inside = reach * reach, error = multiply_add(dot(most, most) + inside, same(16 * v), same(least));
    const Mask moderate = not_below(same(0x1p250), most.x + most.y + most.z + reach) & not_below(reach, same(0x1p-250));
    Mask near = 0, apart = 0;
    for (int turn = 0; turn < turns && ((near | apart | ~moderate) & all_lanes) != all_lanes; ++turn) {
      approach(t, turn);
      for (Lanes& part : t) part = moved(part);
      const InSpace between = displacement(t);
      const Lanes square = dot(between, between);
      Lanes gap = dot(between, way);
      for (const InSpace& edge : edges) gap = gap - farthest(dot(between, edge));
      gap = gap - multiply_add(dot(magnitudes(between), most), same(16 * v), same(least));
      near |= above(inside - square, error);
      apart |= above(gap, same(0)) & above(gap * gap, multiply_add(inside * square, same(1 + 16 * v), same(least)));
    }
    return {moderate & (near | apart), apart};
  }

 private:
  /// A NaN becomes 1.
  static Lanes moved(Lanes t) { return greater(lesser(t, same(1)), same(symmetric ? -1 : 0)); }
  /// The greatest of t_k times a number.
  static Lanes farthest(Lanes along) { return symmetric ? magnitude(along) : greater(along, same(0)); }

  InSpace displacement(const Lanes (&t)[n]) const {
    InSpace rest = way;
    for (std::size_t k = 0; k < n; ++k) rest = rest - t[k] * edges[k];
    return rest;
  }

  void approach(Lanes (&t)[n], int turn) const { Nearest<n, moved>(way, edges).approach(t, turn == 0); }
};

/// The determinant of the half axes goes through five operations: C = 16 v. Half axes that may be dependent are left to
/// other stages.
///
/// The guess begins with the point that makes the displacement zero, by Cramer's rule, brought into the box towards its
/// center.
struct SphereObb {
  static constexpr std::size_t columns = 16;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping
  static Verdict of(const Lanes* c) {
    const InSpace center(c), middle(c + 4), p(c + 7), q(c + 10), r(c + 13);
    const Lanes radius = c[3], sizes = size_of(p) * size_of(q) * size_of(r);
    const InSpace way = center - middle;
    const Lanes determinant = dot(cross(p, q), r);
    Lanes t[] = {dot(way, cross(q, r)), dot(way, cross(r, p)), dot(way, cross(p, q))}, most = magnitude(determinant);
    for (const Lanes& each : t) most = greater(magnitude(each), most);
    const Lanes sign = lesser(greater(determinant * same(0x1p1000), same(-1)), same(1)), per_most = sign / most;
    for (Lanes& each : t) each = each * per_most;
    Verdict found = Cores<3, true>{way, {p, q, r}}.contact(radius, t);
    found.known &= above(magnitude(dot(cross(p, q), r)), multiply_add(sizes, same(16 * v), same(least)));
    return found;
  }
};

/// The guess begins with the point of b's line that is nearest to a's line. One turn takes the nearest point of a to
/// that and the nearest of b to this, which is exact up to rounding (Ericson, Real-Time Collision Detection, 5.1.9).
/// Radii that are 0, or not valid, are left to other stages.
struct CapsuleCapsule {
  static constexpr std::size_t columns = 14;
  static constexpr std::uint8_t set = 0, clear = 2;  // disjoint, overlapping
  static Verdict of(const Lanes* c) {
    const InSpace from(c), to(c + 3), other_from(c + 7), other_to(c + 10);
    const Lanes radius = c[6], other_radius = c[13];
    const Cores<2, false> cores{from - other_from, {from - to, other_to - other_from}};
    const auto& [way, edges] = cores;
    const Lanes aa = dot(edges[0], edges[0]), ab = dot(edges[0], edges[1]), bb = dot(edges[1], edges[1]);
    const Lanes on_line = (aa * dot(edges[1], way) - ab * dot(edges[0], way)) / (aa * bb - ab * ab);
    Lanes t[] = {same(0), greater(lesser(on_line, same(1)), same(0))};
    Verdict found = cores.contact(radius + other_radius, t);
    found.known &= above(lesser(radius, other_radius), same(0));
    return found;
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
