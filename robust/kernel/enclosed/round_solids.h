// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/obb_filter.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/filters/staged.h"

/// The contact of round convex solids whose cores are points, segments, triangles and boxes: a guess of their nearest
/// points, and certain signs that prove it.
///
/// Bounds: the model of sized.h, u = 2^-52; numbers of the input are `moderate`. With s for the sum of the magnitudes
/// of the terms of a sum, ways and edges being terms as they are computed, each term goes through at most k operations.
/// So the sum is off by ((1 + u)^k - 1) s at most, and s as computed is at least (1 - u)^k s. For k <= 32 the first is
/// less than 2^-46 times the second. Not proved by machine.
namespace touchstone::robust::filters {

inline constexpr double error_of_32_roundings = 0x1p-46;

inline bool moderate(const Obb3d& box) {
  return moderate(box.center) & moderate(box.half_axes.u) & moderate(box.half_axes.v) & moderate(box.half_axes.w);
}

/// True if three vectors are certainly linearly independent. Five operations for each term of the determinant.
inline bool independent(const Vector3d& u, const Vector3d& v, const Vector3d& w) {
  const double sizes = size_of<double>(u) * size_of<double>(v) * size_of<double>(w);
  return FloatFormat<double>::magnitude(dot(cross(u, v), w)) > error_of_32_roundings * sizes;
}

/// Two cores: the displacements from a point of one to a point of the other are way - sum t_k edge_k, with t_k in [-1,
/// 1] for the first, symmetric edges, and in [0, 1] for the others; if the last two are edges of a triangle, the sum of
/// theirs is at most 1. Each coordinate of the way and of edges is a number of the input or the difference of two of
/// them. It is then off by u of itself at most; a sum of more numbers may cancel, and be off by more than that.
template <std::size_t n, std::size_t symmetric = n, bool triangle = false>
struct Differences {
  std::array<Vector3d, n> edges;
  Vector3d way;

  /// The contact of the solids, `reach` being the sum of their radii; empty if it is not certain. They overlap if the
  /// cores are nearer than the reach. Only for solids of which that is true: one core has an interior, or both radii
  /// are not 0.
  ///
  /// The guess of the t_k: the foot of the perpendicular along each edge, moved into its interval, which for edges at
  /// right angles is the nearest point; for others again, along one edge after the other. Its proof, for any t_k in
  /// these intervals and any direction: if the displacement is shorter than the reach, there are points as near as
  /// that. If the way leads farther along the direction than the edges and the reach together, all points are farther
  /// apart. The direction is the displacement as computed. A t_k is 0 or at least 2^-30, and a difference of `moderate`
  /// numbers is a multiple of 2^-82, so no product underflows.
  ///
  /// A square goes through one operation in the way, n + 1 in the displacement, twice, and 4 more; a height through no
  /// more than these, and no coordinate of the direction exceeds its length, which is less than 2^-40 of itself off.
  /// The t_k of a triangle, the sum of which may exceed 1 by u, are those of one of its points but for one operation.
  Perhaps<Contact> contact(double reach) const {
    Vector3d most = magnitudes(way);
    for (const Vector3d& edge : edges) most = most + magnitudes(edge);
    const double squares = error_of_32_roundings * (dot(most, most) + reach * reach),
                 heights = error_of_32_roundings * (size_of<double>(most) + reach);
    std::array<double, n> t = first_guess();
    for (int turn = 0; turn < turns; ++turn) {
      const Vector3d between = displacement(t);
      const double square = dot(between, between), length = std::sqrt(square) * (1 + 0x1p-40);
      if (reach * reach - square > squares) return Contact::overlapping;
      double reached = reach * length;
      for (std::size_t k = 0; k < separate; ++k) reached = reached + farthest(k, dot(between, edges[k]));
      if constexpr (triangle) reached = reached + farthest_in_triangle(between);
      if (dot(between, way) - reached > heights * length) return Contact::disjoint;
      if (approach(t) == 0) break;
      if (turn > 0) leap(t);
    }
    return std::nullopt;
  }

  /// The guess alone; what only rounding still moves is not moved again.
  std::array<double, n> guess() const {
    std::array<double, n> t = first_guess();
    for (int turn = 0; turn < turns && approach(t) > 0x1p-48; ++turn)
      leap(t);
    return t;
  }

 private:
  static constexpr int turns = 16;

  std::array<double, n> first_guess() const {
    std::array<double, n> t{};
    for (std::size_t k = 0; k < n; ++k) t[k] = moved(k, t, way);
    return t;
  }

  static double magnitude(double x) { return FloatFormat<double>::magnitude(x); }
  static Vector3d magnitudes(const Vector3d& v) { return {magnitude(v.x), magnitude(v.y), magnitude(v.z)}; }
  static double moderated(double x) { return magnitude(x) < 0x1p-30 ? 0.0 : x; }

  /// The edges whose t_k do not depend on another.
  static constexpr std::size_t separate = triangle ? n - 2 : n;

  static constexpr double least(std::size_t k) { return k < symmetric ? -1 : 0; }
  static double greatest(std::size_t k, const std::array<double, n>& t) {
    return k < separate ? 1.0 : moderated(1 - t[2 * n - 3 - k]);  // less the other of the triangle
  }
  /// The greatest of t_k times a number.
  static double farthest(std::size_t k, double along) { return along > 0 ? along : least(k) * along; }
  /// The greatest height of a corner of the triangle over the first along a direction.
  double farthest_in_triangle(const Vector3d& direction) const {
    const double first = dot(direction, edges[n - 2]), second = dot(direction, edges[n - 1]);
    const double greater = first > second ? first : second;
    return greater > 0 ? greater : 0.0;
  }

  double moved(std::size_t k, const std::array<double, n>& t, const Vector3d& rest) const {
    const double length = dot(edges[k], edges[k]);
    if (!(length > 0)) return 0;
    return within(k, t, t[k] + dot(rest, edges[k]) / length);
  }
  static double within(std::size_t k, const std::array<double, n>& t, double foot) {
    const double most = greatest(k, t);
    return foot > most ? most : foot < least(k) ? least(k) : moderated(foot);
  }

  Vector3d displacement(const std::array<double, n>& t) const {
    Vector3d along = t[0] * edges[0];
    for (std::size_t k = 1; k < n; ++k) along = along + t[k] * edges[k];
    return way - along;
  }

  /// Moves each t_k once; returns how far they have moved together.
  double approach(std::array<double, n>& t) const {
    Vector3d rest = displacement(t);
    double changed = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double next = moved(k, t, rest);
      changed = changed + magnitude(next - t[k]);
      rest = rest - (next - t[k]) * edges[k];
      t[k] = next;
    }
    if constexpr (triangle) changed = changed + slide(t, rest);
    return changed;
  }

  /// Moves the t_k that are not at an end of their interval towards the point that makes the displacement shortest
  /// without regard to the intervals: straight there, or until the first of them is at an end. Where edges are nearly
  /// dependent, approach() moves a little each time.
  void leap(std::array<double, n>& t) const {
    if constexpr (n > 1) {
      const Vector3d rest = displacement(t);
      std::array<std::array<double, n + 1>, n> rows{};
      std::array<double, n> moves{};
      for (std::size_t k = 0; k < n; ++k) {
        if (!open(k, t)) continue;
        for (std::size_t l = 0; l < n; ++l) rows[k][l] = open(l, t) ? dot(edges[k], edges[l]) : 0.0;
        rows[k][n] = dot(rest, edges[k]);
      }
      const std::array<std::array<double, n + 1>, n> before = rows;
      for (std::size_t k = 0; k < n; ++k) {
        if (!(rows[k][k] > 0x1p-40 * before[k][k])) rows[k] = {};  // dependent on those before it, or not open
        for (std::size_t l = k + 1; l < n && rows[k][k] > 0; ++l) {
          const double factor = rows[l][k] / rows[k][k];
          for (std::size_t i = k; i <= n; ++i) rows[l][i] = rows[l][i] - factor * rows[k][i];
        }
      }
      double part = 1;
      const auto stop_at = [&part](double room, double move) {
        if (move > 0 && room < part * move) part = room / move;
      };
      for (std::size_t k = n; k-- > 0;) {
        double height = rows[k][n];
        for (std::size_t l = k + 1; l < n; ++l) height = height - rows[k][l] * moves[l];
        moves[k] = rows[k][k] > 0 ? height / rows[k][k] : 0.0;
        stop_at(greatest(k, t) - t[k], moves[k]), stop_at(t[k] - least(k), -moves[k]);
      }
      if constexpr (triangle) stop_at(1 - (t[n - 2] + t[n - 1]), moves[n - 2] + moves[n - 1]);
      for (std::size_t k = 0; k < n; ++k) t[k] = within(k, t, t[k] + part * moves[k]);
    }
  }
  bool open(std::size_t k, const std::array<double, n>& t) const { return least(k) < t[k] && t[k] < greatest(k, t); }

  /// Along the third side of the triangle; returns how far.
  double slide(std::array<double, n>& t, const Vector3d& rest) const {
    double &first = t[n - 2], &second = t[n - 1];
    const Vector3d side = edges[n - 1] - edges[n - 2];
    const double length = dot(side, side), sum = first + second, most = sum > 1 ? 1.0 : sum;
    if (!(length > 0)) return 0;
    const double foot = second + dot(rest, side) / length, before = second;
    second = foot > most ? most : foot < 0 ? 0.0 : moderated(foot);
    const double left = moderated(most - second), room = greatest(n - 2, t);
    first = left > room ? room : left;
    return magnitude(second - before);
  }
};

}  // namespace touchstone::robust::filters
