// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "geometry/answers.h"
#include "robust/kernel/filters/sized.h"
#include "robust/kernel/filters/staged.h"

/// The contact of round convex solids whose cores are points, segments and boxes: a guess of their nearest points, and
/// certain signs that prove it.
namespace touchstone::robust::filters {

inline Triple<Sized<0>> sized(const Vector3d& v) {
  const auto number = [](double x) { return Sized<0>{x, FloatFormat<double>::magnitude(x)}; };
  return {number(v.x), number(v.y), number(v.z)};
}

/// True if three vectors, of `moderate` numbers, are certainly linearly independent.
inline bool independent(const Triple<Sized<0>>& u, const Triple<Sized<0>>& v, const Triple<Sized<0>>& w) {
  const auto volume = dot(cross(u, v), w);
  return volume.positive() || volume.negative();
}

/// Two cores of `moderate` numbers: the displacements from a point of one to a point of the other are
/// way - sum t_k edge_k with t_k in [-1, 1].
template <std::size_t n, int of_edge, int of_way>
struct Differences {
  std::array<Triple<Sized<of_edge>>, n> edges;
  Triple<Sized<of_way>> way;

  /// The contact of the cores, one or both of them grown by a radius, `reach` being the sum of the radii; empty if it
  /// is not certain. The cores overlap if they are nearer than the reach: one of them has an interior, or both radii
  /// are not 0.
  ///
  /// The guess of the t_k: the foot of the perpendicular along one edge after the other, moved into [-1, 1], which for
  /// edges at right angles is the nearest point. Its proof, for any numbers t_k in [-1, 1] and any direction: if the
  /// displacement is shorter than the reach, there are points as near as that. If along the direction the way leads
  /// farther than the edges and the reach together, all points are farther apart. Numbers of the guess are made
  /// `moderate`, which the proof allows.
  template <int k>
  Perhaps<Contact> contact(const Sized<k>& reach) const {
    std::array<double, n> t{};
    for (int turn = 0; turn < 4; ++turn) {
      const bool moved = approach(t);
      const auto between = displacement(t, std::make_index_sequence<n>());
      if ((reach * reach - dot(between, between)).positive()) return Contact::overlapping;
      if (separates({between.x.value, between.y.value, between.z.value}, reach)) return Contact::disjoint;
      if (!moved) break;
    }
    return std::nullopt;
  }

 private:
  static double moderated(double x) { return FloatFormat<double>::magnitude(x) < 0x1p-30 ? 0.0 : x; }
  static Sized<0> number(double x) { return {x, FloatFormat<double>::magnitude(x)}; }

  /// Moves each t_k once; returns whether any has changed.
  bool approach(std::array<double, n>& t) const {
    const auto value = [](const auto& v) { return Vector3d{v.x.value, v.y.value, v.z.value}; };
    Vector3d rest = value(way);
    for (std::size_t k = 0; k < n; ++k) rest = rest - t[k] * value(edges[k]);
    bool moved = false;
    for (std::size_t k = 0; k < n; ++k) {
      const Vector3d edge = value(edges[k]);
      const double length = dot(edge, edge);
      if (!(length > 0)) continue;
      const double foot = t[k] + dot(rest, edge) / length, next = foot > 1 ? 1.0 : foot < -1 ? -1.0 : moderated(foot);
      if (next == t[k]) continue;
      rest = rest - (next - t[k]) * edge;
      t[k] = next, moved = true;
    }
    return moved;
  }

  template <std::size_t... k>
  auto displacement(const std::array<double, n>& t, std::index_sequence<k...>) const {
    const auto along = [](const auto& from, const auto&... steps) { return from - (... + steps); };
    return Triple{along(way.x, (number(t[k]) * edges[k].x)...), along(way.y, (number(t[k]) * edges[k].y)...),
                  along(way.z, (number(t[k]) * edges[k].z)...)};
  }

  /// The direction is divided by its greatest coordinate: its length is between 1 and 2, and that of what is `moderate`
  /// in it, computed with less than ten roundings, less than 2^-40 of itself off.
  template <int k>
  bool separates(const Vector3d& towards, const Sized<k>& reach) const {
    const auto size = [](double x) { return FloatFormat<double>::magnitude(x); };
    const double x = size(towards.x), y = size(towards.y), z = size(towards.z),
                 most = x > y   ? (x > z ? x : z)
                        : y > z ? y
                                : z;
    if (!(most > 0)) return false;
    const double part = 1 / most;
    const Vector3d direction{moderated(part * towards.x), moderated(part * towards.y), moderated(part * towards.z)};
    const Sized<0> length = number(std::sqrt(dot(direction, direction)) * (1 + 0x1p-40));
    return gap(sized(direction), std::make_index_sequence<n>(), reach * length).positive();
  }
  template <std::size_t... k, class Reach>
  auto gap(const Triple<Sized<0>>& direction, std::index_sequence<k...>, const Reach& reach) const {
    return dot(direction, way) - (reach + (... + magnitude(dot(direction, edges[k]))));
  }
};

}  // namespace touchstone::robust::filters
