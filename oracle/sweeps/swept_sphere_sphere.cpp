// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_sphere.h"

#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/parabola.h"

namespace touchstone::oracle {
namespace {

template <class Number>
using Scale = CommonScale<Number, 14>;

template <class Number>
Scale<Number> validated_swept_sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b,
                                            const Vector3<Number>& velocity_a, const Vector3<Number>& velocity_b) {
  const Scale<Number> n({a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius,
                         velocity_a.x, velocity_a.y, velocity_a.z, velocity_b.x, velocity_b.y, velocity_b.z});
  if (!n.finite() || validation::negative(a.radius) || validation::negative(b.radius)) {
    validation::validate_all("a", a, "b", b, "velocity_a", velocity_a, "velocity_b", velocity_b);
  }
  return n;
}

/// |c + t v|^2 - r^2 in squares of the unit.
template <class Number>
Parabola parabola_swept_sphere_sphere(const Scale<Number>& n) {
  const auto difference = [&n](std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t axis) { return Integer(n.integer(i + axis) - n.integer(j + axis)); };
    return Vector3<Integer>{at(0), at(1), at(2)};
  };
  const Vector3<Integer> position = difference(0, 4), velocity = difference(8, 11);
  const Integer radii(n.integer(3) + n.integer(7));
  return {Integer(dot(position, position) - radii * radii), dot(position, velocity), dot(velocity, velocity)};
}

template <class Number>
Truth<FirstContact<Surd>> truth_swept_sphere_sphere(const Scale<Number>& n) {
  Parabola f = parabola_swept_sphere_sphere(n);
  return {f.contact(), n.actual(Rational(abs(f.least())), 2), [n, f = std::move(f)] {
            const auto actual = [&n](const Integer& coefficient) { return n.actual(Rational(coefficient), 2); };
            return Certificate{f.kind(),
                               {{"polynomial", {actual(f.start), actual(Integer(2 * f.half)), actual(f.square)}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b,
                                              const Vector3<Number>& velocity_a, const Vector3<Number>& velocity_b) {
  return truth_swept_sphere_sphere(validated_swept_sphere_sphere(a, b, velocity_a, velocity_b));
}
template Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3d&, const Sphere3d&, const Vector3d&,
                                                       const Vector3d&);
template Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3<Rational>&, const Sphere3<Rational>&,
                                                       const Vector3<Rational>&, const Vector3<Rational>&);

}  // namespace touchstone::oracle
