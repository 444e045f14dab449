// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/space.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The point of the convex hull of at most four points that is nearest to the origin: the sum of weight k / whole times
/// point k, whole > 0. `normal` is a positive multiple of it, zero only if it is the origin.
template <class Number>
struct NearestToOrigin {
  std::array<Number, 4> weights;
  Number total;
  Vector3<Number> normal;
};

/// A subset of at most four points, in order.
class Chosen {
 public:
  Chosen(unsigned mask, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      if ((mask >> k & 1U) != 0) places_[size_++] = k;
  }
  std::size_t size() const { return size_; }
  std::size_t operator[](std::size_t k) const { return places_[k]; }

 private:
  std::array<std::size_t, 4> places_{};
  std::size_t size_ = 0;
};

/// The foot of the perpendicular on the point, line or plane of the `chosen` points, with all other weights 0; for
/// four, the origin. If these points are dependent, `whole` is 0.
template <class Number>
NearestToOrigin<Number> foot_of_perpendicular(const std::vector<Vector3<Number>>& points, const Chosen& chosen) {
  const Vector3<Number>& p = points[chosen[0]];
  const auto edge = [&](std::size_t k) { return points[chosen[k]] - p; };
  NearestToOrigin<Number> foot{{Number(0), Number(0), Number(0), Number(0)}, Number(1), p};
  const auto weigh = [&](std::size_t k, Number weight) { foot.weights[chosen[k]] = std::move(weight); };
  if (chosen.size() == 2) {
    const Vector3<Number> e = edge(1);
    foot.total = dot(e, e), weigh(1, Number(-dot(e, p)));
    foot.normal = foot.total * p + foot.weights[chosen[1]] * e;
  } else if (chosen.size() > 2) {
    const Vector3<Number> e = edge(1), f = edge(2), n = cross(e, f);
    if (chosen.size() == 3) {
      const Number height = dot(n, p);
      foot.total = dot(n, n), weigh(1, dot(cross(f, p), n)), weigh(2, dot(cross(p, e), n));
      foot.normal = height > 0 ? n : height < 0 ? Number(-1) * n : Vector3<Number>{Number(0), Number(0), Number(0)};
    } else {
      const Vector3<Number> g = edge(3);
      const Number volume = dot(n, g), side(volume < 0 ? 1 : -1);
      foot.total = -side * volume, foot.normal = {Number(0), Number(0), Number(0)};
      weigh(1, Number(side * dot(cross(f, g), p))), weigh(2, Number(side * dot(cross(g, e), p)));
      weigh(3, Number(side * dot(n, p)));
    }
  }
  Number first = foot.total;
  for (std::size_t k = 1; k < chosen.size(); ++k) first -= foot.weights[chosen[k]];
  weigh(0, std::move(first));
  return foot;
}

/// A foot whose weights are positive is the nearest point if no other point lies before the plane through it. The
/// nearest point is such a foot, of some points that are not dependent: in exact numbers it is always found; in doubles
/// perhaps not, or a wrong one.
template <class Number>
std::optional<NearestToOrigin<Number>> nearest_to_origin(const std::vector<Vector3<Number>>& points) {
  for (unsigned mask = (1U << points.size()) - 1; mask > 0; --mask) {
    const Chosen chosen(mask, points.size());
    const NearestToOrigin<Number> foot = foot_of_perpendicular(points, chosen);
    bool nearest = foot.total > 0;
    for (std::size_t k = 0; k < chosen.size(); ++k) nearest = nearest && foot.weights[chosen[k]] > 0;
    for (std::size_t k = 0; k < points.size() && nearest; ++k)
      if ((mask >> k & 1U) == 0) nearest = dot(foot.normal, points[k] - points[chosen[0]]) >= 0;
    if (nearest) return foot;
  }
  return std::nullopt;
}

}  // namespace touchstone::robust::kernel
