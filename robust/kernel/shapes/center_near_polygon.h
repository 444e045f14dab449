// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/shapes/moving_center.h"

/// The center of a moving ball next to a convex polygon at rest, in integers.
namespace touchstone::robust::kernel {

/// The displacements from the corners, in order, to the center, and of a step. A polygon without area is the segment or
/// the point that its corners span; its normal is 0.
template <std::size_t n>
class CenterNearPolygon {
  using Vector = Vector3<mpz_class>;

 public:
  CenterNearPolygon(const std::array<Vector, n>& ways, const Vector& step, const mpz_class& radius)
      : ways_(ways), step_(step), squared_radius_(radius * radius) {
    for (std::size_t k = 0; k < n; ++k) edges_[k] = ways_[k] - ways_[(k + 1) % n];
    normal_ = cross(edges_[0], edges_[1]);
    for (std::size_t k = 0; k < n; ++k)
      sides_[k] = {height(cross(normal_, edges_[k]), k), height(edges_[k], k), height(edges_[k], (k + 1) % n)};
  }

  /// As moving_center.h has it: the nearest face, edge or corner changes where the center passes a plane through a
  /// corner, at right angles to an edge, or one through an edge, at right angles to the face.
  std::optional<SquaredGap> gap_of_contact() const {
    return kernel::gap_of_contact(times_of_change(), [this](const TimeOfStep& t) { return gap_around(t); });
  }
  FirstContact<double> first_contact() const {
    return kernel::first_contact(times_of_change(), [this](const TimeOfStep& t) { return gap_around(t); });
  }

 private:
  TimesOfChange times_of_change() const {
    TimesOfChange times;
    for (const auto& [inwards, past_start, past_end] : sides_)
      for (const HeightOfStep* height : {&inwards, &past_start, &past_end}) times.crosses(*height);
    return times;
  }

  /// By the nearest of face, edges and corners: the face where the center is over it; an edge where the center is
  /// between its ends, and not over the polygon's side of it; else the nearest corner.
  SquaredGap gap_around(const TimeOfStep& t) const {
    const bool has_area = sgn(square(normal_)) != 0;
    if (has_area && over_face(t)) return from_face();
    for (std::size_t k = 0; k < n; ++k)
      if (beside(k, t) && !(has_area && inwards(k, t) > 0)) return from_edge(k);
    return from_corner(nearest_corner(t));
  }

  /// The center relative to an edge: over the line to the other corners, and along the edge over its start and its end.
  struct Side {
    HeightOfStep inwards, past_start, past_end;
  };

  static mpz_class square(const Vector& v) { return dot(v, v); }
  /// The height of the center over a corner.
  HeightOfStep height(const Vector& along, std::size_t corner) const {
    return {dot(along, ways_[corner]), dot(along, step_)};
  }
  int inwards(std::size_t k, const TimeOfStep& t) const { return sides_[k].inwards.sign_at(t); }
  bool over_face(const TimeOfStep& t) const {
    for (std::size_t k = 0; k < n; ++k)
      if (inwards(k, t) < 0) return false;
    return true;
  }
  bool beside(std::size_t k, const TimeOfStep& t) const {
    return sgn(square(edges_[k])) != 0 && sides_[k].past_start.sign_at(t) >= 0 && sides_[k].past_end.sign_at(t) <= 0;
  }
  std::size_t nearest_corner(const TimeOfStep& t) const {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < n; ++k) {
      const HeightOfStep farther{square(ways_[k]) - square(ways_[nearest]), 2 * dot(ways_[k] - ways_[nearest], step_)};
      if (farther.sign_at(t) < 0) nearest = k;
    }
    return nearest;
  }

  SquaredGap from_face() const {
    const auto [start, rise] = height(normal_, 0);
    return {start * start - squared_radius_ * square(normal_), start * rise, rise * rise};
  }
  SquaredGap from_edge(std::size_t k) const {
    const Vector start = cross(ways_[k], edges_[k]), rise = cross(step_, edges_[k]);
    return {square(start) - squared_radius_ * square(edges_[k]), dot(start, rise), square(rise)};
  }
  SquaredGap from_corner(std::size_t k) const {
    return {square(ways_[k]) - squared_radius_, dot(ways_[k], step_), square(step_)};
  }

  std::array<Vector, n> ways_, edges_;  ///< edge k leads from corner k to the next
  Vector step_, normal_;
  mpz_class squared_radius_;
  std::array<Side, n> sides_;
};

inline CenterNearPolygon<3> center_near(const Sphere3d& sphere, const Vector3d& velocity, const Triangle3d& triangle) {
  const auto& [p, radius] = sphere;
  const auto& [a, b, c] = triangle;
  const auto n = integers_of(p.x, p.y, p.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, velocity.x, velocity.y,
                             velocity.z, radius)
                     .at;
  const auto at = [&n](std::size_t i) { return vector_at(n, i); };
  return {{at(0) - at(3), at(0) - at(6), at(0) - at(9)}, at(12), n[15]};
}

}  // namespace touchstone::robust::kernel
