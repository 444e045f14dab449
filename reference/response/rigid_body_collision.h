// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The vector that the inertia maps to l, by Cramer's rule.
template <class Real>
Vector3<Real> turned_by(const Inertia<Real>& inertia, const Vector3<Real>& l) {
  const auto& [x, y, z] = inertia;
  const Vector3<Real> yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
  const Real det = dot(x, yz);
  const Vector3<Real> sum = l.x * yz + l.y * zx + l.z * xy;
  return {Real(sum.x / det), Real(sum.y / det), Real(sum.z / det)};
}

/// The motion of two rotating bodies after they collided at a point, with a coefficient of restitution e.
///
/// Deck p. 74: an impulse j n at the contact, and its opposite, change both motions:
///     va' = va + (j / ma) n, wa' = wa + j Ia^-1 (ra x n), vb' = vb - (j / mb) n, wb' = wb - j Ib^-1 (rb x n),
/// where r = p - position, so that the relative velocity of the two points at p along the normal becomes -e times what
/// it was, v = n . (va + wa x ra - vb - wb x rb):
///     j = -(1 + e) v / ((1 / ma + 1 / mb) n . n + (ra x n) . Ia^-1 (ra x n) + (rb x n) . Ib^-1 (rb x n)).
/// Momentum and angular momentum are kept, and with e = 1 the energy. masses: positive, any unit. inertia: around the
/// body's position and along the axes of space, that unit times squared lengths; symmetric and positive definite. (One
/// that no body of positive mass has, such as (1, 1, 3), is answered by the same law.) normal: of any length but 0, on
/// either side. e: from 0 to 1, without unit. It does not matter whether the bodies approach, nor whether they touch at
/// the point: the law also applies to those that separate.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so are, body by body, an inertia that is not
/// symmetric ("a.inertia[1][0]", "symmetric"), a mass of 0 or less ("a.mass", "mass > 0"), an inertia that is not
/// positive definite, exactly ("a.inertia", "positive definite"); and n = 0 ("normal", "nonzero normal") and an e out
/// of bounds ("e", "between 0 and 1").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-30 and 2^30 in size. With |...|
/// for the same polynomial of the magnitudes of all differences and numbers, all its terms added: let k be |det I| /
/// det I, of the body with the greater one, Q = |adj I| |r x n| / det I, D the denominator of j, l = |D| / D, and J =
/// (1 + e) |v| / D, taken exactly. Where 100 k l u <= 1, a component of va' is off by at most
///     (100 k l J |n_i| / ma + 2 |va_i|) u + 2^-1060, and of wa' by (100 k l J Q_i + 2 |wa_i|) u + 2^-1060,
/// and b's likewise: r x n is off by 3u of its magnitudes, adj I by 2u, their product by 8u, det I by 5u k, so Ia^-1
/// (ra x n) by 14u k Q; the denominator by 22u k |D|, v by 9u of its magnitudes; so j by (12 + 22 k l / (1 - 22 k l u))
/// u J < 41 k l u J, and its products by 15u k more; the rest is for what is of higher order and for the last sums. In
/// exact arithmetic the formula is always right.
/// ulps: 183 roundings (67 a body for p - position, r x n, the inverse of the inertia and their products, 11 for the
/// rest of the denominator, 32 for the velocity, three for j, three for what it changes).
template <class Real>
Motions<Real> rigid_body_collision(const RigidBody<Real>& a, const RigidBody<Real>& b, const Point3<Real>& point,
                                   const Vector3<Real>& normal, const Real& e) {
  const Vector3<Real> ra = point - a.position, rb = point - b.position;
  const Vector3<Real> moment_a = cross(ra, normal), moment_b = cross(rb, normal);
  const Vector3<Real> turn_a = turned_by(a.inertia, moment_a), turn_b = turned_by(b.inertia, moment_b);
  const Vector3<Real> apart =
      (a.velocity + cross(a.angular_velocity, ra)) - (b.velocity + cross(b.angular_velocity, rb));
  const Real masses = Real(Real(Real(1) / a.mass) + Real(Real(1) / b.mass));
  const Real per_impulse = Real(Real(masses * dot(normal, normal)) + dot(moment_a, turn_a) + dot(moment_b, turn_b));
  const Real j = Real(-Real(Real(Real(1) + e) * dot(normal, apart)) / per_impulse);
  return {{a.velocity + Real(j / a.mass) * normal, a.angular_velocity + j * turn_a},
          {b.velocity - Real(j / b.mass) * normal, b.angular_velocity - j * turn_b}};
}

}  // namespace touchstone::reference
