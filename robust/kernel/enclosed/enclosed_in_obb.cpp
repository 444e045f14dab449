// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/enclosed/enclosed_in_obb.h"

#include <array>

#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/enclosed/window.h"

namespace touchstone::robust::kernel {
namespace {

using LooseVector = filters::Triple<Loose>;

double positive_zero(double x) { return validation::zero(x) ? 0.0 : x; }
bool surely_positive(const Loose& x) { return x.settled() && x.high > 0; }

LooseVector sum(const LooseVector& v, const LooseVector& w) { return {v.x + w.x, v.y + w.y, v.z + w.z}; }
LooseVector negative(const LooseVector& v) { return {-v.x, -v.y, -v.z}; }
LooseVector times(const Loose& t, const LooseVector& v) { return {t * v.x, t * v.y, t * v.z}; }

/// Seen from the point, and times `unit`, which is positive: the foot of the perpendicular, and its coefficients of the
/// vectors that span the edge or face; and the square of its distance times `unit` once.
struct Foot {
  LooseVector place;
  std::array<Loose, 2> coefficients;
  Loose square, unit;
};

/// On the edge or face through `from` that the first `count` vectors span, or at that point.
Foot foot_of_perpendicular(const LooseVector& from, const std::array<LooseVector, 3>& edges, std::size_t count) {
  const Loose zero(0);
  const auto& [e, f, rest] = edges;
  if (count == 0) return {from, {zero, zero}, dot(from, from), Loose(1)};
  if (count == 1) {
    const Loose along = -dot(from, e), unit = dot(e, e);
    const LooseVector across = cross(from, e);
    return {sum(times(unit, from), times(along, e)), {along, zero}, dot(across, across), unit};
  }
  const LooseVector normal = cross(e, f);
  const Loose height = dot(from, normal);
  return {times(height, normal),
          {dot(cross(f, from), normal), dot(cross(from, e), normal)},
          height * height,
          dot(normal, normal)};
}

/// The foot that is certainly the nearest point of the box, with a unit that is certainly positive.
std::optional<Foot> nearest_foot(const Point3d& point, const Obb3d& obb) {
  using filters::moderate;
  if (!(moderate(point) & moderate(obb)) || !rounds_to_nearest()) return std::nullopt;
  const auto& [u, v, w] = obb.half_axes;
  const auto guess = filters::Differences<3>{{u, v, w}, point - obb.center}.guess();
  const std::array half_axes{loose(u), loose(v), loose(w)};
  std::array free = half_axes, outwards = half_axes;
  std::size_t frees = 0, fixed = 0;
  LooseVector from = loose_between(point, obb.center);
  for (std::size_t k = 0; k < 3; ++k) {
    if (guess[k] > -1 && guess[k] < 1) {
      free[frees++] = half_axes[k];
    } else {
      outwards[fixed] = guess[k] > 0 ? half_axes[k] : negative(half_axes[k]);
      from = sum(from, outwards[fixed++]);
    }
  }
  if (fixed == 0) return std::nullopt;
  const Foot foot = foot_of_perpendicular(from, free, frees);
  const auto& [place, coefficients, square, unit] = foot;
  for (std::size_t k = 0; k < frees; ++k)
    if (!surely_positive(unit - coefficients[k]) || !surely_positive(unit + coefficients[k])) return std::nullopt;
  for (std::size_t k = 0; k < fixed; ++k)
    if (!surely_positive(-dot(place, outwards[k]))) return std::nullopt;
  if (!surely_positive(unit)) return std::nullopt;
  return foot;
}

}  // namespace

Perhaps<ClosestPoint3<double>> closest_in_obb(const Point3d& point, const Obb3d& obb) {
  if (const auto location = filters::point_in_obb<double>(obb, point); location && *location == Location::inside)
    return ClosestPoint3<double>{{positive_zero(point.x), positive_zero(point.y), positive_zero(point.z)}, 0, 0};
  const auto foot = nearest_foot(point, obb);
  if (!foot) return std::nullopt;
  const auto& [place, coefficients, square, unit] = *foot;
  const Divisor<double> divisor(unit);
  const auto coordinate = [&divisor](double start, const Loose& way) {
    return rounded(Loose(start) + Loose(way / divisor));
  };
  const auto x = coordinate(point.x, place.x), y = coordinate(point.y, place.y), z = coordinate(point.z, place.z);
  const Loose squared_distance = square / divisor;
  if (!x || !y || !z || !surely_positive(squared_distance)) return std::nullopt;
  const auto squared = rounded(squared_distance), distance = rounded(square_root(squared_distance));
  if (!squared || !distance) return std::nullopt;
  return ClosestPoint3<double>{{*x, *y, *z}, *squared, *distance};
}

Perhaps<Contact> close_contact(const Sphere3d& sphere, const Obb3d& obb) {
  const auto foot = filters::moderate(sphere.radius) ? nearest_foot(sphere.center, obb) : std::nullopt;
  if (!foot) return std::nullopt;
  const Loose radius(sphere.radius), apart = ordered(foot->square - radius * radius * foot->unit);
  if (!certain(apart)) return std::nullopt;
  return apart.high > 0 ? Contact::disjoint : Contact::overlapping;
}

}  // namespace touchstone::robust::kernel
