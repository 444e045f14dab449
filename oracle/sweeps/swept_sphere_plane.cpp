// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_plane.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/parabola.h"
#include "oracle/exact/numbers/space.h"

namespace touchstone::oracle {
namespace {

/// E at the start, its change in a step, r^2 and N . N.
struct Approach {
  Rational height, rise, squared_radius, squared_normal;

  Rational start() const { return Rational(height * height - squared_radius * squared_normal); }
  Rational half() const { return Rational(height * rise); }
  Rational square() const { return Rational(rise * rise); }
};

template <class Number>
Approach examine(const Sphere3<Number>& sphere, const Vector3<Number>& velocity, const Plane<Number>& plane) {
  validation::validate_all("sphere", sphere, "velocity", velocity, "plane", plane);
  const Plane<Rational> exactly = exact(plane);
  const Vector3<Rational> v{exact(velocity.x), exact(velocity.y), exact(velocity.z)};
  const Rational radius = exact(sphere.radius);
  return {height_over(exactly, exact(sphere.center)), dot(exactly.normal, v), Rational(radius * radius),
          dot(exactly.normal, exactly.normal)};
}

/// f times a common denominator, which moves no zero.
Parabola parabola_swept_sphere_plane(const Approach& a) {
  Rational start = a.start(), half = a.half(), square = a.square();
  Integer common(1);
  for (const Rational* coefficient : {&start, &half, &square})
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), coefficient->get_den_mpz_t());
  const auto integer = [&common](const Rational& c) { return Integer(c.get_num() * (common / c.get_den())); };
  return {integer(start), integer(half), integer(square)};
}

Rational margin(const Approach& a) {
  const auto with_sign = [&a](const Rational& height) { return Rational(height * abs(height) / a.squared_normal); };
  const Rational end(a.height + a.rise);
  const Rational above(a.squared_radius + with_sign(std::max(a.height, end))),
      below(a.squared_radius - with_sign(std::min(a.height, end)));
  return Rational(abs(std::min(above, below)));
}

template <class Number>
Truth<FirstContact<Surd>> truth_swept_sphere_plane(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                   const Plane<Number>& plane) {
  Approach a = examine(sphere, velocity, plane);
  Parabola f = parabola_swept_sphere_plane(a);
  return {f.contact(), margin(a), [a = std::move(a), f = std::move(f)] {
            return Certificate{f.kind(), {{"polynomial", {a.start(), Rational(2 * a.half()), a.square()}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                             const Plane<Number>& plane) {
  return truth_swept_sphere_plane(sphere, velocity, plane);
}
template Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3d&, const Vector3d&, const Plane3d&);
template Truth<FirstContact<Surd>> swept_sphere_plane(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                      const Plane<Rational>&);

}  // namespace touchstone::oracle
