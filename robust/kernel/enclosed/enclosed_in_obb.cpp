// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/enclosed/enclosed_in_obb.h"

#include <array>

#include "robust/kernel/enclosed/loose.h"
#include "robust/kernel/enclosed/round_solids.h"
#include "robust/kernel/enclosed/window.h"

namespace touchstone::robust::kernel {
namespace {

using LooseVector = filters::Triple<Loose>;
using SizedVector = filters::Triple<filters::Sized<1>>;
using SizedPlace = filters::Triple<filters::Sized<4>>;  ///< a difference and up to three sums

double positive_zero(double x) { return validation::zero(x) ? 0.0 : x; }
bool surely_positive(const Loose& x) { return x.settled() && x.high > 0; }
template <int k>
bool surely_positive(const filters::Sized<k>& x) {
  return x.positive();
}

template <class X, class Y>
auto sum(const filters::Triple<X>& v, const filters::Triple<Y>& w) {
  return filters::Triple{v.x + w.x, v.y + w.y, v.z + w.z};
}
template <class X>
auto negative(const filters::Triple<X>& v) {
  return filters::Triple{-v.x, -v.y, -v.z};
}
template <class T, class X>
auto times(const T& t, const filters::Triple<X>& v) {
  return filters::Triple{t * v.x, t * v.y, t * v.z};
}

SizedVector sized(const Vector3d& v) {
  const auto one = [](double x) { return filters::Sized<1>{x, filters::FloatFormat<double>::magnitude(x)}; };
  return {one(v.x), one(v.y), one(v.z)};
}
void move(LooseVector& place, const LooseVector& by) { place = sum(place, by); }
void move(SizedPlace& place, const SizedVector& by) {
  const auto add = [](filters::Sized<4>& x, const filters::Sized<1>& y) { x = {x.value + y.value, x.size + y.size}; };
  add(place.x, by.x), add(place.y, by.y), add(place.z, by.z);
}

/// An edge or a face of the box, or a corner, seen from the point: that through `from` which the first `frees` of
/// `free` span; the half axes `outwards` lead to it from within the box.
template <class Place, class Edge>
struct BoxPart {
  Place from;
  std::array<Edge, 3> free, outwards;
  std::size_t frees = 0, fixed = 0;

  /// Takes what the guess says of the box with its center at `center`, seen from the point.
  BoxPart(const Place& center, const std::array<Edge, 3>& half_axes, const std::array<double, 3>& guess)
      : from(center), free(half_axes), outwards(half_axes) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (guess[k] > -1 && guess[k] < 1) {
        free[frees++] = half_axes[k];
      } else {
        outwards[fixed] = guess[k] > 0 ? half_axes[k] : negative(half_axes[k]);
        move(from, outwards[fixed++]);
      }
    }
  }

  /// True if it certainly has the nearest point: the foot of the perpendicular is on it, and the box behind it.
  bool nearest() const {
    const auto& [e, f, rest] = free;
    if (frees == 0) return behind(from);
    if (frees == 1) {
      const auto along = -dot(from, e);
      const auto unit = dot(e, e);
      return within(along, unit) && behind(sum(times(unit, from), times(along, e)));
    }
    const auto normal = cross(e, f);
    const auto unit = dot(normal, normal);
    return within(dot(cross(f, from), normal), unit) && within(dot(cross(from, e), normal), unit) &&
           surely_positive(-(dot(from, normal) * dot(normal, outwards[0])));
  }

 private:
  bool behind(const auto& place) const {
    for (std::size_t k = 0; k < fixed; ++k)
      if (!surely_positive(-dot(place, outwards[k]))) return false;
    return true;
  }
  static bool within(const auto& coefficient, const auto& unit) {
    return surely_positive(unit - coefficient) && surely_positive(unit + coefficient);
  }
};

/// The foot of the perpendicular seen from the point, and times `unit`, which is positive; and the square of its
/// distance times `unit` once.
struct Foot {
  LooseVector place;
  Loose square, unit;
};

Foot foot_of_perpendicular(const BoxPart<LooseVector, LooseVector>& part) {
  const auto& [e, f, rest] = part.free;
  const LooseVector& from = part.from;
  if (part.frees == 0) return {from, dot(from, from), Loose(1)};
  if (part.frees == 1) {
    const LooseVector across = cross(from, e);
    const Loose unit = dot(e, e);
    return {sum(times(unit, from), times(-dot(from, e), e)), dot(across, across), unit};
  }
  const LooseVector normal = cross(e, f);
  const Loose height = dot(from, normal);
  return {times(height, normal), height * height, dot(normal, normal)};
}

/// The foot that is certainly the nearest point of the box, with a unit that is certainly positive.
std::optional<Foot> nearest_foot(const Point3d& point, const Obb3d& obb) {
  using filters::moderate;
  if (!(moderate(point) & moderate(obb)) || !rounds_to_nearest()) return std::nullopt;
  const auto& [u, v, w] = obb.half_axes;
  const auto guess = filters::Differences<3>{{u, v, w}, point - obb.center}.guess();
  const auto [cx, cy, cz] = filters::sized_between(point, obb.center);
  const auto wide = [](const filters::Sized<1>& x) { return filters::Sized<4>{x.value, x.size}; };
  const BoxPart<SizedPlace, SizedVector> sized_part({wide(cx), wide(cy), wide(cz)}, {sized(u), sized(v), sized(w)},
                                                    guess);
  const BoxPart<LooseVector, LooseVector> part(loose_between(point, obb.center), {loose(u), loose(v), loose(w)}, guess);
  if (part.fixed == 0 || !(sized_part.nearest() || part.nearest())) return std::nullopt;
  const Foot foot = foot_of_perpendicular(part);
  if (!surely_positive(foot.unit)) return std::nullopt;
  return foot;
}

}  // namespace

Perhaps<ClosestPoint3<double>> closest_in_obb(const Point3d& point, const Obb3d& obb) {
  if (const auto location = filters::point_in_obb<double>(obb, point); location && *location == Location::inside)
    return ClosestPoint3<double>{{positive_zero(point.x), positive_zero(point.y), positive_zero(point.z)}, 0, 0};
  const auto foot = nearest_foot(point, obb);
  if (!foot) return std::nullopt;
  const auto& [place, square, unit] = *foot;
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
