// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/impact.h"

#include "oracle/exact/numbers/normal_frame.h"

namespace touchstone::oracle {
namespace {

template <class Number>
Vector3<Integer> integer_normal(const Vector3<Number>& n) {
  return integer_vector(CommonScale<Number, 3>({n.x, n.y, n.z}), 0);
}

Rational doubled_energy(const Masses<Rational>& m, const Velocities<Rational>& v) {
  return Rational(m.first * dot(v.first, v.first) + m.second * dot(v.second, v.second));
}

template <class Number>
Certificate impulse_certificate(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                const Vector3<Number>& normal, const Velocities<Rational>& after) {
  const Masses<Rational> m{exact(masses.first), exact(masses.second)};
  const Velocities<Rational> before{exact_vector(velocities.first), exact_vector(velocities.second)};
  const Vector3<Rational> n = exact_vector(normal);
  const Rational impulse(m.first * dot(after.first - before.first, n) / dot(n, n));
  return {"impulse",
          {{"impulse", {impulse}}, {"doubled_energies", {doubled_energy(m, before), doubled_energy(m, after)}}}};
}

}  // namespace

template <class Number>
Vector3<Rational> after_bounce(const Vector3<Number>& velocity, const Vector3<Number>& normal, const Rational& k) {
  const CommonScale<Number, 3> speeds({velocity.x, velocity.y, velocity.z});
  const Vector3<Integer> v = integer_vector(speeds, 0), n = integer_normal(normal);
  return actual_vector(speeds, NormalFrame(n).with_product(Rational(-k * Rational(dot(v, n))), v));
}
template Vector3<Rational> after_bounce(const Vector3d&, const Vector3d&, const Rational&);
template Vector3<Rational> after_bounce(const Vector3<Rational>&, const Vector3<Rational>&, const Rational&);

template <class Number>
Truth<Vector3<Rational>> bounced(const Vector3<Number>& velocity, const Vector3<Number>& normal, const Rational& k) {
  return {after_bounce(velocity, normal, k), std::nullopt, [velocity, normal] {
            const Vector3<Rational> across = after_bounce(velocity, normal, Rational(0));
            return Certificate{"decomposition",
                               {{"along", listed(exact_vector(velocity) - across)}, {"across", listed(across)}}};
          }};
}
template Truth<Vector3<Rational>> bounced(const Vector3d&, const Vector3d&, const Rational&);
template Truth<Vector3<Rational>> bounced(const Vector3<Rational>&, const Vector3<Rational>&, const Rational&);

template <class Number>
Truth<Velocities<Rational>> after_impact(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                         const Vector3<Number>& normal, const Rational& e) {
  const auto& [v, w] = velocities;
  const CommonScale<Number, 6> speeds({v.x, v.y, v.z, w.x, w.y, w.z});
  const CommonScale<Number, 2> weights({masses.first, masses.second});
  const Vector3<Integer> n = integer_normal(normal), first = integer_vector(speeds, 0),
                         second = integer_vector(speeds, 3);
  const Integer m1 = weights.integer(0), m2 = weights.integer(1), p1 = dot(first, n), p2 = dot(second, n);
  // q1 - q2 = apart, and m1 q1 + m2 q2 = m1 p1 + m2 p2: m1 times the first taken from the second leaves q2.
  const Rational apart(-e * Rational(Integer(p1 - p2)));
  const Rational q2((Rational(Integer(m1 * p1 + m2 * p2)) - Rational(m1) * apart) / Rational(Integer(m1 + m2)));
  const NormalFrame frame(n);
  Velocities<Rational> after{actual_vector(speeds, frame.with_product(Rational(q2 + apart), first)),
                             actual_vector(speeds, frame.with_product(q2, second))};
  return {after, std::nullopt, [=] { return impulse_certificate(masses, velocities, normal, after); }};
}
template Truth<Velocities<Rational>> after_impact(const Massesd&, const Velocitiesd&, const Vector3d&, const Rational&);
template Truth<Velocities<Rational>> after_impact(const Masses<Rational>&, const Velocities<Rational>&,
                                                  const Vector3<Rational>&, const Rational&);

}  // namespace touchstone::oracle
