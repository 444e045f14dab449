// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/rigid_body_collision.h"

#include <array>
#include <utility>

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {
namespace {

using ExactBody = RigidBody<Rational>;
using ExactMotion = Motion<Rational>;

template <class Number>
ExactBody exact_body(const RigidBody<Number>& body) {
  const Vector3<Rational> x = from_origin(body.position);
  return {exact(body.mass),
          {exact_vector(body.inertia.x), exact_vector(body.inertia.y), exact_vector(body.inertia.z)},
          {x.x, x.y, x.z},
          exact_vector(body.velocity),
          exact_vector(body.angular_velocity)};
}

/// w with I w = l, by elimination; a positive definite matrix has no zero pivot.
Vector3<Rational> turned_by(const Inertia<Rational>& inertia, const Vector3<Rational>& l) {
  const auto& [x, y, z] = inertia;
  std::array<std::array<Rational, 4>, 3> rows{{{x.x, x.y, x.z, l.x}, {y.x, y.y, y.z, l.y}, {z.x, z.y, z.z, l.z}}};
  for (std::size_t pivot = 0; pivot < 3; ++pivot)
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == pivot) continue;
      const Rational share(rows[row][pivot] / rows[pivot][pivot]);
      for (std::size_t i = pivot; i < 4; ++i) rows[row][i] -= share * rows[pivot][i];
    }
  return {Rational(rows[0][3] / rows[0][0]), Rational(rows[1][3] / rows[1][1]), Rational(rows[2][3] / rows[2][2])};
}

Vector3<Rational> angular_momentum(const Inertia<Rational>& inertia, const Vector3<Rational>& w) {
  return {dot(inertia.x, w), dot(inertia.y, w), dot(inertia.z, w)};
}

/// A body and the change of its motion by a unit of impulse along the normal, or against it.
struct Struck {
  ExactBody body;
  Vector3<Rational> arm;
  ExactMotion change;

  Struck(ExactBody of, const Vector3<Rational>& point, const Vector3<Rational>& push)
      : body(std::move(of)), arm(point - from_origin(body.position)) {
    change = {Rational(1 / body.mass) * push, turned_by(body.inertia, cross(arm, push))};
  }

  ExactMotion after(const Rational& impulse) const {
    return {body.velocity + impulse * change.velocity, body.angular_velocity + impulse * change.angular_velocity};
  }
  Vector3<Rational> at_contact(const Rational& impulse) const {
    const ExactMotion motion = after(impulse);
    return motion.velocity + cross(motion.angular_velocity, arm);
  }
  Rational doubled_energy(const Rational& impulse) const {
    const ExactMotion motion = after(impulse);
    return Rational(body.mass * dot(motion.velocity, motion.velocity) +
                    dot(motion.angular_velocity, angular_momentum(body.inertia, motion.angular_velocity)));
  }
};

struct Collision {
  Struck a, b;
  Rational impulse;
};

/// The inertia by its leading minors.
template <class Number>
ExactBody validated(const std::string& field, const RigidBody<Number>& body) {
  validation::validate(field, body);
  ExactBody exactly = exact_body(body);
  const auto& [x, y, z] = exactly.inertia;
  const Rational second = x.x * y.y - x.y * y.x;
  if (sgn(x.x) <= 0 || sgn(second) <= 0 || sgn(dot(cross(x, y), z)) <= 0)
    validation::refuse(field, RigidBodyd::definite);
  return exactly;
}

template <class Number>
Collision collide(const RigidBody<Number>& a, const RigidBody<Number>& b, const Point3<Number>& point,
                  const Vector3<Number>& normal, const Number& e) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b),
      validation::validate_numbers("point", point);
  validation::validate_numbers("normal", normal), validation::validate_numbers("e", e);
  ExactBody of_a = validated("a", a), of_b = validated("b", b);
  validation::validate("normal", normal, rule::normal);
  validation::validate("e", e, rule::restitution);
  const Vector3<Rational> n = exact_vector(normal), p = from_origin(point);
  Collision result{{std::move(of_a), p, n}, {std::move(of_b), p, Rational(-1) * n}, Rational(0)};
  const auto apart = [&](const Rational& impulse) {
    return dot(n, result.a.at_contact(impulse) - result.b.at_contact(impulse));
  };
  const Rational before = apart(Rational(0)), gained(apart(Rational(1)) - before);
  result.impulse = (-exact(e) * before - before) / gained;
  return result;
}

template <class Number>
Truth<Motions<Rational>> truth_rigid_body_collision(const RigidBody<Number>& a, const RigidBody<Number>& b,
                                                    const Point3<Number>& point, const Vector3<Number>& normal,
                                                    const Number& e) {
  Collision c = collide(a, b, point, normal, e);
  Motions<Rational> after{c.a.after(c.impulse), c.b.after(c.impulse)};
  return {std::move(after), std::nullopt, [c = std::move(c)] {
            const auto energy = [&c](const Rational& impulse) {
              return Rational(c.a.doubled_energy(impulse) + c.b.doubled_energy(impulse));
            };
            return Certificate{
                "impulse_at",
                {{"impulse", {c.impulse}}, {"doubled_energies", {energy(Rational(0)), energy(c.impulse)}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<Motions<Rational>> rigid_body_collision(const RigidBody<Number>& a, const RigidBody<Number>& b,
                                              const Point3<Number>& point, const Vector3<Number>& normal,
                                              const Number& e) {
  return truth_rigid_body_collision(a, b, point, normal, e);
}
template Truth<Motions<Rational>> rigid_body_collision(const RigidBodyd&, const RigidBodyd&, const Point3d&,
                                                       const Vector3d&, const double&);
template Truth<Motions<Rational>> rigid_body_collision(const RigidBody<Rational>&, const RigidBody<Rational>&,
                                                       const Point3<Rational>&, const Vector3<Rational>&,
                                                       const Rational&);

}  // namespace touchstone::oracle
