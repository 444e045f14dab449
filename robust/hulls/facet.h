// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "robust/hulls/frame.h"
#include "robust/kernel/shapes/face_side.h"

namespace touchstone::robust::hulls {

/// A point in the frame, and its index in the list. next: the following point in the list of points above a facet.
struct FramePoint {
  double x, y, z;
  std::int32_t place, next;

  bool at(const FramePoint& p) const { return ((x == p.x) & (y == p.y) & (z == p.z)) != 0; }
  double operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
};

/// A triangle of a surface, counter-clockwise from outside, and its plane: n . p - d is positive outside and off by at
/// most `error`. Edge i goes from corner i to the next; beyond it lies neighbour i.
struct alignas(64) Facet {
  double n[3], d;
  std::int32_t corner[3], beyond[3];
  float error;
  std::int32_t above;  ///< the farthest of the points kept for this facet, -1 if there are none

  double height(const FramePoint& p) const { return n[0] * p.x + n[1] * p.y + n[2] * p.z - d; }
  bool alive() const { return corner[0] >= 0; }
};

/// Decides on which sides of facets' planes the points of one frame lie.
class Sides {
 public:
  Sides(const Frame& frame, Grain grain, Stage& latest)
      : reach_(frame.reach), narrow_(grain == Grain::narrow), wide_(grain == Grain::wide), latest_(latest) {
    if (narrow_) latest_ = std::max(latest_, Stage::lattice);
  }

  /// The same of the same frame, for another thread.
  Sides(const Sides& of, Stage& latest) : reach_(of.reach_), narrow_(of.narrow_), wide_(of.wide_), latest_(latest) {}

  /// A decision needed that stage.
  void note(Stage stage) const { latest_ = std::max(latest_, stage); }
  bool narrow() const { return narrow_; }

  /// The plane of a facet through its corners.
  ///
  /// With the differences u = b - a and v = c - a, n_k = u_i v_j - u_j v_i, Q_k = |u_i v_j| + |u_j v_i| and R_k the
  /// reach: n_k is off by 4 u Q_k (two differences, a product, the last difference; u = 2^-53), and is multiplied by
  /// |p_k - a_k| <= 2 R_k: 8 u in units of the sum of Q_k R_k. n . p and n . a lose 3 u each (a product, two sums),
  /// their difference, at most twice the sum, 2 u. Together 16 u; 20 u pays for terms of u^2 and for the bound's own
  /// roundings. Underflow costs less than 2^-1070 (1 + R_0 + R_1 + R_2). If a term overflows the bound is infinite:
  /// then nothing is certain. Below 1e37 nothing overflows, and the bound may be a float. Not proved by machine.
  ///
  /// On a narrow lattice n_k is below 2^35, n . p and d below 3 * 2^51 in units of 2^-45, and all of it is exact.
  /// Where u and v have no extent on an axis, n . p - d is the difference of two numbers on it, and has its sign.
  void span(Facet& f, const FramePoint& a, const FramePoint& b, const FramePoint& c) const {
    const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
    double terms = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = k == 2 ? 0 : k + 1, j = 3 - k - i;
      const double p = u[i] * v[j], q = u[j] * v[i];
      f.n[k] = p - q;
      terms += (std::fabs(p) + std::fabs(q)) * reach_[k];
    }
    f.d = f.n[0] * a.x + f.n[1] * a.y + f.n[2] * a.z;
    f.error = 0;
    if (narrow_) return;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((u[k] == 0) & (v[k] == 0)) return lie_across(f, k, a, b, c);
    }
    const double error = 0x1.4p-49 * terms + 0x1p-1000 * (1 + reach_[0] + reach_[1] + reach_[2]);
    if (error < double{std::numeric_limits<float>::min()}) f.error = std::numeric_limits<float>::min();
    else f.error = error < 1e37 ? static_cast<float>(error * (1 + 1e-6)) : std::numeric_limits<float>::infinity();
  }

  /// Returns 1 above, 0 on the plane, -1 below, and sets `height`. points: holds the facet's corners.
  int of(const Facet& f, const FramePoint& p, const std::vector<FramePoint>& points, double& height) const {
    height = f.height(p);
    if (height > double{f.error}) return 1;
    if (height < -double{f.error}) return -1;
    return f.error == 0 ? 0 : exactly(f, p, points);
  }

  bool collinear(const FramePoint& a, const FramePoint& b, const FramePoint& c) const;
  /// Returns 1, 0, -1: the turn at b, from the coordinates i and j alone.
  int turn(std::size_t i, std::size_t j, const FramePoint& a, const FramePoint& b, const FramePoint& c) const;

 private:
  void lie_across(Facet& f, std::size_t k, const FramePoint& a, const FramePoint& b, const FramePoint& c) const;
  int exactly(const Facet& f, const FramePoint& p, const std::vector<FramePoint>& points) const;

  std::array<double, 3> reach_;
  bool narrow_, wide_;
  Stage& latest_;
};

}  // namespace touchstone::robust::hulls
