// SPDX-License-Identifier: Apache-2.0
#include "robust/response/rigid_body_collision.h"

#include <cstdint>

#include "robust/kernel/contacts/along_normal.h"
#include "robust/kernel/enclosed/enclosed_inertia.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {

/// The slide's formula for both bodies at once, each step with its bound. A bound holds whatever the steps before: no
/// sum of bounds needs a proof here. Flattened: passing an enclosure through memory costs more than a product.
[[gnu::flatten]] Perhaps<Motions<double>> stages::rigid_body_collision::enclosed(const RigidBodyd& a,
                                                                                 const RigidBodyd& b, const Point3d& p,
                                                                                 const Vector3d& n, double e) {
  using namespace kernel;
  Bounded bounded;
  const Two mass(a.mass, b.mass);
  const auto beside = [&bounded](const auto& v, const auto& w) {
    const Vector3<Two> both{Two(v.x, w.x), Two(v.y, w.y), Two(v.z, w.z)};
    bounded.inputs(both.x, both.y, both.z);
    return both;
  };
  const Vector3<Two> position = beside(a.position, b.position), velocity = beside(a.velocity, b.velocity),
                     turning = beside(a.angular_velocity, b.angular_velocity), point = beside(p, p);
  bounded.inputs(mass, Two(n.x, n.y), Two(n.z, e));
  const EnclosedInertia inertia(a.inertia, b.inertia, bounded);
  const bool symmetric = kernel::symmetric(a.inertia) && kernel::symmetric(b.inertia);
  if (!bounded.hold() || !symmetric || !inertia.positive_definite() || !(mass >= Two(0x1p-30)) || !(0 <= e && e <= 1) ||
      !rounds_to_nearest())
    return std::nullopt;

  const Vector3<Factor<Two>> normal = factors(n),
                             arm{vector_between(position.x, point.x), vector_between(position.y, point.y),
                                 vector_between(position.z, point.z)};
  const EnclosedVectors moment = bounded(enclosed_cross(arm, normal));
  const EnclosedVectors turn = bounded(inertia.turned_by(moment));
  const EnclosedPair square = bounded(enclosed_dots(normal, normal)), weight = kernel::enclosed(mass);
  if (square.high.first() == 0) return std::nullopt;  // refused
  const EnclosedPair mobility = square / Divisor(weight) + enclosed_dot(moment, turn);
  const EnclosedPair speed =
      enclosed_dots(factors(velocity.x, velocity.y, velocity.z), normal) +
      enclosed_dot({kernel::enclosed(turning.x), kernel::enclosed(turning.y), kernel::enclosed(turning.z)}, moment);
  const Enclosed<double> apart = bounded(first(speed) - second(speed)),
                         below = bounded(first(mobility) + second(mobility));
  const Pair<double> bounce = two_sum(1.0, e);
  const Enclosed<double> impulse = bounded(Enclosed<double>{bounce.high, bounce.low, 0} * apart / Divisor(below));
  const EnclosedPair pushes = both(-impulse, impulse), push = bounded(pushes / Divisor(weight));
  if (!bounded.hold()) return std::nullopt;
  const auto x = rounded(along(velocity.x, push, normal.x)), y = rounded(along(velocity.y, push, normal.y)),
             z = rounded(along(velocity.z, push, normal.z)),
             wx = rounded(kernel::enclosed(turning.x) + pushes * turn.x),
             wy = rounded(kernel::enclosed(turning.y) + pushes * turn.y),
             wz = rounded(kernel::enclosed(turning.z) + pushes * turn.z);
  if (!x || !y || !z || !wx || !wy || !wz) return std::nullopt;
  return Motions<double>{{{x->first(), y->first(), z->first()}, {wx->first(), wy->first(), wz->first()}},
                         {{x->second(), y->second(), z->second()}, {wx->second(), wy->second(), wz->second()}}};
}

namespace {

using kernel::Dyadic;

Inertia<Dyadic> exactly(const Inertiad& i) { return {kernel::dyadic(i.x), kernel::dyadic(i.y), kernel::dyadic(i.z)}; }

/// A body, and its rotation by a unit impulse, times the determinant of its inertia.
struct Struck {
  Dyadic mass, determinant, bend;
  Vector3<Dyadic> velocity, angular_velocity, turn, at_contact;

  Struck(const RigidBodyd& body, const Vector3<Dyadic>& point, const Vector3<Dyadic>& n)
      : mass(kernel::dyadic(body.mass)),
        velocity(kernel::dyadic(body.velocity)),
        angular_velocity(kernel::dyadic(body.angular_velocity)) {
    const auto [x, y, z] = exactly(body.inertia);
    const Point3d& p = body.position;
    const Vector3<Dyadic> arm = point - kernel::dyadic(Vector3d{p.x, p.y, p.z}), moment = cross(arm, n),
                          yz = cross(y, z);
    determinant = dot(x, yz);
    turn = {dot(yz, moment), dot(cross(z, x), moment), dot(cross(x, y), moment)};
    bend = dot(moment, turn);
    at_contact = velocity + cross(angular_velocity, arm);
  }
};

/// start + (of / below) v, rounded.
Vector3d moved(const Vector3<Dyadic>& start, const Dyadic& of, const Vector3<Dyadic>& v, const Dyadic& below) {
  const auto component = [&](const Dyadic& from, const Dyadic& along) {
    const Dyadic n = from * below + of * along;
    return kernel::round_quotient(n.n, below.n, static_cast<std::int64_t>(n.exponent) - below.exponent);
  };
  return {component(start.x, v.x), component(start.y, v.y), component(start.z, v.z)};
}

bool positive_definite(const Inertiad& inertia) {
  const Inertia<Dyadic> i = exactly(inertia);
  const Vector3<Dyadic> xy = cross(i.x, i.y);
  return sgn(i.x.x.n) > 0 && sgn(xy.z.n) > 0 && sgn(dot(xy, i.z).n) > 0;
}

void validate_body(const std::string& field, const RigidBodyd& body) {
  validation::validate(field, body);
  if (!positive_definite(body.inertia)) validation::refuse(field, RigidBodyd::definite);
}

void validate_rigid_body_collision(const RigidBodyd& a, const RigidBodyd& b, const Point3d& point,
                                   const Vector3d& normal, double e) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b),
      validation::validate_numbers("point", point);
  validation::validate_numbers("normal", normal), validation::validate_numbers("e", e);
  validate_body("a", a), validate_body("b", b);
  if (kernel::valid(point) && kernel::valid(normal, rule::normal) && kernel::valid(e, rule::restitution)) return;
  validation::validate("point", point), validation::validate("normal", normal, rule::normal);
  validation::validate("e", e, rule::restitution);
}

}  // namespace

/// Everything over the product of both masses, both determinants, and the effective inverse mass.
Motions<double> stages::rigid_body_collision::exact(const RigidBodyd& a, const RigidBodyd& b, const Point3d& p,
                                                    const Vector3d& normal, double e) {
  const Vector3<Dyadic> n = kernel::dyadic(normal), point = kernel::dyadic(Vector3d{p.x, p.y, p.z});
  const Struck of_a(a, point, n), of_b(b, point, n);
  const Dyadic determinants = of_a.determinant * of_b.determinant, masses = of_a.mass * of_b.mass;
  const Dyadic below = (of_a.mass + of_b.mass) * determinants * dot(n, n) +
                       masses * (of_a.bend * of_b.determinant + of_b.bend * of_a.determinant);
  const Dyadic bounce = (kernel::dyadic(1.0) + kernel::dyadic(e)) * dot(n, of_a.at_contact - of_b.at_contact);
  return {{moved(of_a.velocity, -(bounce * of_b.mass * determinants), n, below),
           moved(of_a.angular_velocity, -(bounce * masses * of_b.determinant), of_a.turn, below)},
          {moved(of_b.velocity, bounce * of_a.mass * determinants, n, below),
           moved(of_b.angular_velocity, bounce * masses * of_a.determinant, of_b.turn, below)}};
}

Decided<Motions<double>> stages::rigid_body_collision::ask(const RigidBodyd& a, const RigidBodyd& b, const Point3d& p,
                                                           const Vector3d& n, double e) {
  return in_turn<rigid_body_collision, Stage::enclosed, validate_rigid_body_collision, Stage::exact>(a, b, p, n, e);
}

Motions<double> rigid_body_collision(const RigidBodyd& a, const RigidBodyd& b, const Point3d& point,
                                     const Vector3d& normal, double e) {
  return answer_in_turn<stages::rigid_body_collision, Stage::enclosed, validate_rigid_body_collision, Stage::exact>(
      a, b, point, normal, e);
}

}  // namespace touchstone::robust
