// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/truth.h"

/// The effect of a bounce, on integers: velocities in one unit, the normal in another, and the same in doubles and
/// rationals.
namespace touchstone::oracle {

template <class Scale>
Vector3<Integer> integer_vector(const Scale& scale, std::size_t i) {
  return {scale.integer(i), scale.integer(i + 1), scale.integer(i + 2)};
}
/// In units, unchanged.
template <class Scale>
Vector3<Rational> actual_vector(const Scale& scale, const Vector3<Rational>& v) {
  return {scale.actual(v.x, 1), scale.actual(v.y, 1), scale.actual(v.z, 1)};
}
template <class Number>
Vector3<Rational> exact_vector(const Vector3<Number>& v) {
  return {exact(v.x), exact(v.y), exact(v.z)};
}
template <class Number>
Vector3<Rational> from_origin(const Point3<Number>& p) {
  return {exact(p.x), exact(p.y), exact(p.z)};
}
inline std::vector<Rational> listed(const Vector3<Rational>& v) { return {v.x, v.y, v.z}; }

/// The velocity of a particle after a bounce off a plane: the one whose product with the normal is multiplied by -k,
/// and whose products with vectors perpendicular to the normal stay. Requires valid arguments.
template <class Number>
Vector3<Rational> after_bounce(const Vector3<Number>& velocity, const Vector3<Number>& normal, const Rational& k);

/// The same as the truth of an operation, with the certificate "decomposition": the parts of the velocity, `along` the
/// normal and `across` it.
template <class Number>
Truth<Vector3<Rational>> bounced(const Vector3<Number>& velocity, const Vector3<Number>& normal, const Rational& k);

/// The velocities of two bodies after a bounce: momentum along the normal and the relative velocity along it, -e times
/// what it was, are two linear equations for their products with the normal; products with vectors across it stay.
/// Valid arguments. Certificate: "impulse": the number j with m1 (v1' - v1) = j n, and twice the kinetic energy before
/// and after.
template <class Number>
Truth<Velocities<Rational>> after_impact(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                         const Vector3<Number>& normal, const Rational& e);

}  // namespace touchstone::oracle
