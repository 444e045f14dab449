// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/sphere_aabb.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/nearest_in_interval.h"

namespace touchstone::oracle {
namespace {

/// The radius, then axis by axis the center's coordinate, min and max.
template <class Number>
CommonScale<Number, 7> scale_of_sphere_aabb(const Circle2<Number>& s, const Aabb2<Number>& b) {
  return CommonScale<Number, 7>({s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y});
}
template <class Number>
CommonScale<Number, 10> scale_of_sphere_aabb(const Sphere3<Number>& s, const Aabb3<Number>& b) {
  return CommonScale<Number, 10>(
      {s.radius, s.center.x, b.min.x, b.max.x, s.center.y, b.min.y, b.max.y, s.center.z, b.min.z, b.max.z});
}

/// In units of the scale; x is the box's point nearest to the center c.
template <class Value>
struct Axis {
  Value c, min, max, x;
};
template <class Value, std::size_t Axes>
struct BallAndBox {
  Value radius;
  std::array<Axis<Value>, Axes> axes;

  /// R - S
  Value depth() const {
    Value left(radius * radius);
    for (const auto& axis : axes) left -= Value((axis.x - axis.c) * (axis.x - axis.c));
    return left;
  }
  const Axis<Value>& narrowest() const {
    return *std::min_element(axes.begin(), axes.end(), [](const auto& first, const auto& second) {
      return first.max - first.min < second.max - second.min;
    });
  }
};

template <class Value, class Number, std::size_t N>
BallAndBox<Value, N / 3> solids_of(const CommonScale<Number, N>& n) {
  BallAndBox<Value, N / 3> solids{integer<Value>(n, 0), {}};
  for (std::size_t k = 0; k < N / 3; ++k) {
    const Value c = integer<Value>(n, 3 * k + 1), min = integer<Value>(n, 3 * k + 2),
                max = integer<Value>(n, 3 * k + 3);
    solids.axes[k] = {c, min, max, nearest_in_interval(c, min, max).x};
  }
  return solids;
}

/// The solids; refuses invalid input.
template <class Value, class Scale, class Ball, class Box>
auto validated_sphere_aabb(const Scale& n, const Ball& sphere, const Box& aabb) {
  const auto validate = [&] { validation::validate_all("sphere", sphere, "aabb", aabb); };
  if (!n.finite()) validate();
  const auto solids = solids_of<Value>(n);
  const auto in_order = [](const auto& axis) { return axis.min <= axis.max; };
  if (solids.radius < 0 || !std::all_of(solids.axes.begin(), solids.axes.end(), in_order)) validate();
  return solids;
}

/// From the nearest point x a fraction t of the displacement w to the middle of the box: inside it for t > 0, because
/// on each axis the middle is. The squared distance from the center grows by 2 t (x - c) . w + t^2 w . w, which is less
/// than the depth for t = depth / (depth + 2 (x - c) . w + w . w) <= 1; (x - c) . w is not negative, since x is
/// nearest.
template <class Solids>
std::vector<Rational> common_interior_point(const Solids& solids) {
  const Rational depth = rational(solids.depth());
  Rational growth = 0;
  std::vector<Rational> displacement;
  for (const auto& axis : solids.axes) {
    const Rational x = rational(axis.x), w((rational(axis.min) + rational(axis.max)) / 2 - x);
    growth += w * (2 * (x - rational(axis.c)) + w);
    displacement.push_back(w);
  }
  const Rational t(depth / (depth + growth));
  for (std::size_t k = 0; k < displacement.size(); ++k)
    displacement[k] = rational(solids.axes[k].x) + t * displacement[k];
  return displacement;
}

template <class Scale, class Solids>
Certificate certificate_sphere_aabb(const Scale& n, const Solids& solids) {
  const int depth = sgn(solids.depth());
  const auto& narrowest = solids.narrowest();
  const bool flat = narrowest.min == narrowest.max;
  const bool overlap = depth > 0 && !flat;
  std::vector<Rational> point;
  if (overlap) point = common_interior_point(solids);
  else
    for (const auto& axis : solids.axes) point.push_back(rational(axis.x));
  for (Rational& coordinate : point) coordinate = n.actual(coordinate, 1);
  const char* kind = depth < 0    ? "nearest_point"
                     : depth == 0 ? "tangent"
                     : flat       ? "flat_axis"
                                  : "common_interior_point";
  Certificate certificate{kind, {{"point", std::move(point)}}};
  if (depth > 0 && flat)
    certificate.facts.push_back({"axis", {Rational(static_cast<std::int64_t>(&narrowest - solids.axes.data()))}});
  return certificate;
}

template <class Value, class Scale, class Ball, class Box>
Truth<Contact> truth_sphere_aabb(const Scale& n, const Ball& sphere, const Box& aabb) {
  auto solids = validated_sphere_aabb<Value>(n, sphere, aabb);
  const Value depth = solids.depth();
  const Value extent(solids.narrowest().max - solids.narrowest().min), square(extent * extent);
  const Value margin(depth < square ? depth : square);
  return {sgn(margin) < 0   ? Contact::disjoint
          : sgn(margin) > 0 ? Contact::overlapping
                            : Contact::touching,
          n.actual(absolute(margin), 2),
          [n, solids = std::move(solids)] { return certificate_sphere_aabb(n, solids); }};
}

template <class Ball, class Box>
Truth<Contact> truth_of_sphere_aabb(const Ball& sphere, const Box& aabb) {
  const auto n = scale_of_sphere_aabb(sphere, aabb);
  return n.finite() && n.bits() <= most_bits_in_words ? truth_sphere_aabb<Int128>(n, sphere, aabb)
                                                      : truth_sphere_aabb<Integer>(n, sphere, aabb);
}

}  // namespace

template <Exact Number>
Truth<Contact> sphere_aabb(const Circle2<Number>& sphere, const Aabb2<Number>& aabb) {
  return truth_of_sphere_aabb(sphere, aabb);
}
template <Exact Number>
Truth<Contact> sphere_aabb(const Sphere3<Number>& sphere, const Aabb3<Number>& aabb) {
  return truth_of_sphere_aabb(sphere, aabb);
}
template Truth<Contact> sphere_aabb(const Circle2d&, const Aabb2d&);
template Truth<Contact> sphere_aabb(const Sphere3d&, const Aabb3d&);
template Truth<Contact> sphere_aabb(const Circle2<Rational>&, const Aabb2<Rational>&);
template Truth<Contact> sphere_aabb(const Sphere3<Rational>&, const Aabb3<Rational>&);

}  // namespace touchstone::oracle
