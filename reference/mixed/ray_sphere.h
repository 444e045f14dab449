// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/rays.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The t at which a line is as far from a center as the radius, by the quadratic formula: for p and v relative to the
/// center, A t^2 + B t + C = 0 with A = v . v, B = 2 p . v, C = p . p - r^2.
template <class Real>
struct RootsOfSphere {
  bool real = false;
  Real smaller = Real(0), greater = Real(0);

  RootsOfSphere() = default;
  RootsOfSphere(const Real& square, const Real& linear, const Real& constant) {
    using std::sqrt;
    const Real discriminant = Real(Real(linear * linear) - Real(Real(Real(4) * square) * constant));
    if (!(Real(0) <= discriminant)) return;
    const Real root = Real(sqrt(discriminant)), below = Real(Real(2) * square);
    real = true;
    smaller = Real(Real(-linear - root) / below), greater = Real(Real(root - linear) / below);
  }
  template <class Vector>
  RootsOfSphere(const Vector& p, const Vector& v, const Real& r)
      : RootsOfSphere(dot(v, v), Real(Real(2) * dot(p, v)), Real(dot(p, p) - Real(r * r))) {}
};

template <class Real>
Passage<Real> passage_of_ray(const RootsOfSphere<Real>& roots) {
  if (!roots.real || !(Real(0) <= roots.greater)) return {PassageRelation::none, std::nullopt, std::nullopt};
  return {PassageRelation::hit, roots.smaller < Real(0) ? Real(0) : roots.smaller, roots.greater};
}

/// Finds where a ray enters and leaves a ball, or in the plane a disc, by the quadratic formula.
///
/// No page of the deck asks this. The formula is that of swept_sphere_sphere.h (p. 23, 51) for a point and a ball at
/// rest, with both roots: p = origin - center, v = direction. `none` where the discriminant B^2 - 4 A C or the greater
/// root is negative; otherwise `hit` from the smaller root, or 0 if that is negative, to the greater.
/// ray, sphere: any unit of length, the same for both; t is in units of the direction's length. Closed sets: the origin
/// and the boundary belong to them, so a tangent ray is a hit, with first = last. first is 0 if the origin is in the
/// ball. The ball is solid: a ray that starts inside has met it. Radius 0 (or -0) is a point.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so are a direction of length 0
/// ("ray.direction", "nonzero direction") and a negative radius ("sphere.radius", "radius >= 0"). first and last are
/// infinite if the exact ones are beyond the range of doubles.
///
/// In exact arithmetic the formula is always right.
///
/// Rounding (binary64, to nearest, u = 2^-53), where A and Q = p . p + r^2 are in [2^-480, 2^480]; M = A Q. There are
/// no more roundings than in swept_sphere_sphere.h, so with D the discriminant, e(D) = 104u M, s = sqrt(D), a root T is
/// off by at most
///     e(T) = 7u sqrt(Q / A) + 53u Q / s + 9u |T| + 2^-1074   where D > e(D).
/// `none` is right where D < -e(D), and where D > e(D) and the greater root is below -e. `hit` is right where D > e(D)
/// and the greater root is above e; then last is as good as e of that root, and first as e of the smaller.
/// ulps: 24 roundings behind first and last (one in p; six in B, five in A, seven in C; three in D; root, sum,
/// quotient).
template <class Real>
Passage<Real> ray_sphere(const Ray2<Real>& ray, const Circle2<Real>& sphere) {
  return passage_of_ray(RootsOfSphere<Real>(ray.origin - sphere.center, ray.direction, sphere.radius));
}
template <class Real>
Passage<Real> ray_sphere(const Ray3<Real>& ray, const Sphere3<Real>& sphere) {
  return passage_of_ray(RootsOfSphere<Real>(ray.origin - sphere.center, ray.direction, sphere.radius));
}

}  // namespace touchstone::reference
