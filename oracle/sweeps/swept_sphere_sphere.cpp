// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_sphere.h"

#include <array>

#include "oracle/exact/common_scale.h"
#include "oracle/exact/rational_validation.h"

namespace touchstone::oracle {
namespace {

template <class Number>
using Scale = CommonScale<Number, 14>;

template <class Number>
Scale<Number> validated(const Sphere3<Number>& a, const Sphere3<Number>& b, const Vector3<Number>& velocity_a,
                        const Vector3<Number>& velocity_b) {
  const Scale<Number> n({a.center.x, a.center.y, a.center.z, a.radius, b.center.x, b.center.y, b.center.z, b.radius,
                         velocity_a.x, velocity_a.y, velocity_a.z, velocity_b.x, velocity_b.y, velocity_b.z});
  if (!n.finite() || validation::negative(a.radius) || validation::negative(b.radius)) {
    validation::validate("a", a), validation::validate("b", b);
    validation::validate("velocity_a", velocity_a), validation::validate("velocity_b", velocity_b);
  }
  return n;
}

/// square t^2 + 2 half t + start, in squares of the unit.
struct Parabola {
  Integer start, half, square;

  Integer end() const { return Integer(start + 2 * half + square); }
  Integer half_slope_at_end() const { return Integer(half + square); }
  Integer discriminant() const { return Integer(half * half - square * start); }
};

template <class Number>
Parabola parabola(const Scale<Number>& n) {
  const auto difference = [&n](std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t axis) { return Integer(n.whole(i + axis) - n.whole(j + axis)); };
    return Vector3<Integer>{at(0), at(1), at(2)};
  };
  const Vector3<Integer> position = difference(0, 4), velocity = difference(8, 11);
  const Integer radii(n.whole(3) + n.whole(7));
  return {Integer(dot(position, position) - radii * radii), dot(position, velocity), dot(velocity, velocity)};
}

int changes_of_sign(const std::array<int, 3>& chain) {
  int changes = 0, last = 0;
  for (const int sign : chain) {
    changes += sign != 0 && last == -sign;
    if (sign != 0) last = sign;
  }
  return changes;
}

/// The zeros in (0, 1], each counted once, of a parabola with f(0) > 0: Sturm's chain is f, half its derivative, and
/// the remainder of these two with its sign changed, which has the sign of the discriminant.
int zeros_within(const Parabola& f) {
  if (sgn(f.square) == 0) return 0;  // no velocity: constant
  const int remainder = sgn(f.discriminant());
  return changes_of_sign({sgn(f.start), sgn(f.half), remainder}) -
         changes_of_sign({sgn(f.end()), sgn(f.half_slope_at_end()), remainder});
}

FirstContact<Surd> contact(const Parabola& f) {
  if (sgn(f.start) <= 0) return {HitRelation::hit, Surd(Rational(0))};
  if (zeros_within(f) == 0) return {HitRelation::never, std::nullopt};
  const Rational square(f.square);
  return {HitRelation::hit, Surd(Rational(-f.half / square), Rational(-1 / square), Rational(f.discriminant()))};
}

/// The least value in [0, 1].
Rational least(const Parabola& f) {
  if (sgn(f.half) >= 0) return Rational(f.start);
  if (sgn(f.half_slope_at_end()) <= 0) return Rational(f.end());
  return quotient(Integer(-f.discriminant()), f.square);
}

template <class Number>
Truth<FirstContact<Surd>> truth(const Scale<Number>& n) {
  const Parabola f = parabola(n);
  return {contact(f), n.actual(Rational(abs(least(f))), 2)};
}

/// In this order: a claim of `never` has a kind that fits, since only the last has its least value inside the step.
const char* kind_of(const Parabola& f) {
  if (sgn(f.start) <= 0) return "start";
  if (zeros_within(f) != 0) return "first_root";
  if (sgn(f.half) >= 0) return "receding";
  return sgn(f.half_slope_at_end()) <= 0 ? "too_late" : "no_root";
}

}  // namespace

Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                              const Vector3d& velocity_b) {
  return truth(validated(a, b, velocity_a, velocity_b));
}

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3<Number>& a, const Sphere3<Number>& b,
                                              const Vector3<Number>& velocity_a, const Vector3<Number>& velocity_b) {
  return truth(validated(a, b, velocity_a, velocity_b));
}
template Truth<FirstContact<Surd>> swept_sphere_sphere(const Sphere3<Rational>&, const Sphere3<Rational>&,
                                                       const Vector3<Rational>&, const Vector3<Rational>&);

Certificate swept_sphere_sphere_certificate(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                            const Vector3d& velocity_b) {
  const Scale<double> n = validated(a, b, velocity_a, velocity_b);
  const Parabola f = parabola(n);
  const auto actual = [&n](const Integer& coefficient) { return n.actual(Rational(coefficient), 2); };
  return {kind_of(f), {{"polynomial", {actual(f.start), actual(Integer(2 * f.half)), actual(f.square)}}}};
}

}  // namespace touchstone::oracle
