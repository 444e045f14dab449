// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/contact_state.h"

#include <utility>

#include "oracle/exact/systems/impact.h"

namespace touchstone::oracle {
namespace {

/// The velocity of the point that moves with a body and is now at the origin, and the rotation around it.
struct Twist {
  Vector3<Rational> of_origin, turn;

  template <class Number>
  explicit Twist(const MovingBody<Number>& body) : turn(exact_vector(body.angular_velocity)) {
    of_origin = exact_vector(body.velocity) + cross(from_origin(body.position), turn);
  }

  Vector3<Rational> at(const Vector3<Rational>& point) const { return of_origin + cross(turn, point); }
};

template <class Number>
Truth<ContactState> truth_contact_state(const MovingBody<Number>& a, const MovingBody<Number>& b,
                                        const Point3<Number>& point, const Vector3<Number>& normal) {
  validation::validate_all("a", a, "b", b, "point", point, "normal", validation::under(rule::normal, normal));
  Twist of_a(a), of_b(b);
  const Vector3<Rational> n = exact_vector(normal), moment = cross(from_origin(point), n);
  const Rational apart(dot(of_a.of_origin - of_b.of_origin, n) + dot(of_a.turn - of_b.turn, moment));
  const int sign = sgn(apart);
  return {sign > 0   ? ContactState::separating
          : sign < 0 ? ContactState::colliding
                     : ContactState::resting,
          Rational(apart * apart / dot(n, n)),
          [of_a = std::move(of_a), of_b = std::move(of_b), p = from_origin(point)] {
            return Certificate{"point_velocities", {{"of_a", listed(of_a.at(p))}, {"of_b", listed(of_b.at(p))}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<ContactState> contact_state(const MovingBody<Number>& a, const MovingBody<Number>& b, const Point3<Number>& point,
                                  const Vector3<Number>& normal) {
  return truth_contact_state(a, b, point, normal);
}
template Truth<ContactState> contact_state(const MovingBodyd&, const MovingBodyd&, const Point3d&, const Vector3d&);
template Truth<ContactState> contact_state(const MovingBody<Rational>&, const MovingBody<Rational>&,
                                           const Point3<Rational>&, const Vector3<Rational>&);

}  // namespace touchstone::oracle
