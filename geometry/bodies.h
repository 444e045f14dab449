// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/space.h"
#include "geometry/volumes.h"

namespace touchstone {

/// A body that does not turn. A mass is positive; 0 and less are refused.
template <class Real>
struct Body {
  Real mass;
  Vector3<Real> velocity;
  static constexpr auto members = as_record("mass", "velocity");
  bool rules(const auto& check) const { return check("mass", rule::mass(mass)); }
};

/// The masses of two bodies.
template <class Real>
struct Masses {
  Real first, second;
  static constexpr auto members = as_list("first", "second");
  bool rules(const auto& check) const {
    return check({"", 0}, rule::mass(first)) && check({"", 1}, rule::mass(second));
  }
};
template <class Real>
struct Velocities {
  Vector3<Real> first, second;
  static constexpr auto members = as_list("first", "second");
};

/// A body that may turn, where nothing but its motion counts. The angular velocity is in radians a unit of time, around
/// the position.
template <class Real>
struct MovingBody {
  Point3<Real> position;
  Vector3<Real> velocity, angular_velocity;
  static constexpr auto members = as_record("position", "velocity", "angular_velocity");
};

/// The rows of a matrix that maps angular velocity to angular momentum, around the position of its body and along the
/// axes of space. One that is not symmetric or not positive definite is refused.
template <class Real>
struct Inertia {
  Vector3<Real> x, y, z;
  static constexpr auto members = as_list("x", "y", "z");
  bool rules(const auto& check) const {
    const auto equal = [](const Real& a, const Real& b) { return rule::Outcome{validation::same(a, b), "symmetric"}; };
    return check({"", 1, 0}, equal(x.y, y.x)) && check({"", 2, 0}, equal(x.z, z.x)) &&
           check({"", 2, 1}, equal(y.z, z.y));
  }
};

template <class Real>
struct RigidBody {
  Real mass;
  Inertia<Real> inertia;
  Point3<Real> position;
  Vector3<Real> velocity, angular_velocity;
  static constexpr auto members = as_record("mass", "inertia", "position", "velocity", "angular_velocity");
  bool rules(const auto& check) const { return check.part("inertia", inertia) && check("mass", rule::mass(mass)); }
  static constexpr rule::Exact definite{"inertia", "positive definite"};
};

/// A body among many. inverse_mass 0 is a body that nothing moves; a negative one is refused.
template <class Real>
struct PointBody {
  Real inverse_mass;
  Vector3<Real> velocity;
  static constexpr auto members = as_record("inverse_mass", "velocity");
  bool rules(const auto& check) const { return check("inverse_mass", rule::inverse_mass(inverse_mass)); }
};

/// The contact of two bodies of a list. The normal points from b to a, so that n . (va - vb) > 0 separates them; it has
/// any length but 0, which is refused. An index beyond the list and a body that touches itself are refused, too.
template <class Real>
struct BodyContact {
  Index a, b;
  Vector3<Real> normal;
  static constexpr auto members = as_record("a", "b", "normal");
  bool rules(const auto& check) const { return check("normal", rule::normal(normal)); }
  /// And those that a list of so many bodies adds; they come first.
  bool rules_among(std::size_t bodies, const auto& check) const {
    return check("a", {a < bodies, "index of a body"}) && check("b", {b < bodies, "index of a body"}) &&
           check("b", {a != b, "another body than a"}) && rules(check);
  }
};

/// The motion of two bodies at a contact at this moment; resting is exactly 0.
enum class ContactState { separating, resting, colliding };
constexpr auto words_of(ContactState) { return as_words("separating", "resting", "colliding"); }

/// How a body moves after an impulse.
template <class Real>
struct Motion {
  Vector3<Real> velocity, angular_velocity;
  static constexpr auto members = as_record("velocity", "angular_velocity");
};
template <class Real>
struct Motions {
  Motion<Real> a, b;
  static constexpr auto members = as_record("a", "b");
};

using Bodyd = Body<double>;
using Massesd = Masses<double>;
using Velocitiesd = Velocities<double>;
using MovingBodyd = MovingBody<double>;
using Inertiad = Inertia<double>;
using RigidBodyd = RigidBody<double>;
using PointBodyd = PointBody<double>;
using BodyContactd = BodyContact<double>;

}  // namespace touchstone
