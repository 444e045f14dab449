// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/sphere_sphere.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"

namespace touchstone::oracle {
namespace {

/// Centers and radii: of a, then of b.
template <class Number>
CommonScale<Number, 6> scale_of_sphere_sphere(const Circle2<Number>& a, const Circle2<Number>& b) {
  return CommonScale<Number, 6>({a.center.x, a.center.y, a.radius, b.center.x, b.center.y, b.radius});
}
template <class Number>
CommonScale<Number, 8> scale_of_sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b) {
  return CommonScale<Number, 8>(
      {a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius});
}

/// In units of the scale.
template <class Value, std::size_t Axes>
struct SphereSpherePair {
  std::array<Value, Axes> from, between;  ///< the center of a; the displacement from there to the center of b
  Value r, s;

  Value squared_distance() const {
    Value sum(0);
    for (const Value& step : between) sum += step * step;
    return sum;
  }
  Value squared_reach() const { return Value((r + s) * (r + s)); }
  /// Its sign determines the contact.
  Value depth() const { return Value(squared_reach() - std::max({squared_distance(), Value(r * r), Value(s * s)})); }
};

template <class Value, class Number, std::size_t N>
SphereSpherePair<Value, N / 2 - 1> pair_of(const CommonScale<Number, N>& n) {
  constexpr std::size_t axes = N / 2 - 1;
  SphereSpherePair<Value, axes> pair{{}, {}, integer<Value>(n, axes), integer<Value>(n, 2 * axes + 1)};
  for (std::size_t k = 0; k < axes; ++k) {
    pair.from[k] = integer<Value>(n, k);
    pair.between[k] = integer<Value>(n, axes + 1 + k) - pair.from[k];
  }
  return pair;
}

/// Refuses invalid input.
template <class Scale, class Solid>
void validate_sphere_sphere(const Scale& n, const Solid& a, const Solid& b) {
  if (!n.finite() || validation::negative(a.radius) || validation::negative(b.radius))
    validation::validate_all("a", a, "b", b);
}

template <class Scale, class SphereSpherePair>
Certificate certificate_sphere_sphere(const Scale& n, const SphereSpherePair& pair) {
  const auto distance = pair.squared_distance(), reach = pair.squared_reach();
  if (distance > reach) return {"distance", {{"squared_distance", {n.actual(rational(distance), 2)}}}};
  // It divides the line between the centers in the ratio of the radii, so it is in both, and inside if that is
  // possible.
  const Rational share =
      sgn(reach) == 0 ? Rational(0) : Rational(rational(pair.r) / (rational(pair.r) + rational(pair.s)));
  std::vector<Rational> point;
  for (std::size_t k = 0; k < pair.from.size(); ++k)
    point.push_back(n.actual(Rational(rational(pair.from[k]) + share * rational(pair.between[k])), 1));
  const char* kind = distance == reach ? "tangent" : sgn(pair.depth()) == 0 ? "no_interior" : "common_interior_point";
  return {kind, {{"point", std::move(point)}}};
}

template <class Value, class Scale>
Truth<Contact> truth_sphere_sphere(const Scale& n) {
  auto pair = pair_of<Value>(n);
  const Value depth = pair.depth();
  return {sgn(depth) < 0   ? Contact::disjoint
          : sgn(depth) > 0 ? Contact::overlapping
                           : Contact::touching,
          n.actual(absolute(depth), 2), [n, pair = std::move(pair)] { return certificate_sphere_sphere(n, pair); }};
}

template <class Solid>
Truth<Contact> truth_of_sphere_sphere(const Solid& a, const Solid& b) {
  const auto n = scale_of_sphere_sphere(a, b);
  validate_sphere_sphere(n, a, b);
  return n.bits() <= most_bits_in_words ? truth_sphere_sphere<Int128>(n) : truth_sphere_sphere<Integer>(n);
}

}  // namespace

template <Exact Number>
Truth<Contact> sphere_sphere(const Circle2<Number>& a, const Circle2<Number>& b) {
  return truth_of_sphere_sphere(a, b);
}
template <Exact Number>
Truth<Contact> sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b) {
  return truth_of_sphere_sphere(a, b);
}
template Truth<Contact> sphere_sphere(const Circle2d&, const Circle2d&);
template Truth<Contact> sphere_sphere(const Sphere3d&, const Sphere3d&);
template Truth<Contact> sphere_sphere(const Circle2<Rational>&, const Circle2<Rational>&);
template Truth<Contact> sphere_sphere(const Sphere3<Rational>&, const Sphere3<Rational>&);

}  // namespace touchstone::oracle
