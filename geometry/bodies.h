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
};

/// Of two bodies.
template <class Real>
struct Masses {
  Real first, second;
};
template <class Real>
struct Velocities {
  Vector3<Real> first, second;
};

/// A body that may turn, where nothing but its motion counts. The angular velocity is in radians a unit of time, around
/// the position.
template <class Real>
struct MovingBody {
  Point3<Real> position;
  Vector3<Real> velocity, angular_velocity;
};

/// The rows of a matrix that maps angular velocity to angular momentum, around the position of its body and along the
/// axes of space. One that is not symmetric or not positive definite is refused.
template <class Real>
struct Inertia {
  Vector3<Real> x, y, z;
};

template <class Real>
struct RigidBody {
  Real mass;
  Inertia<Real> inertia;
  Point3<Real> position;
  Vector3<Real> velocity, angular_velocity;
};

/// A body among many. inverse_mass 0 is a body that nothing moves; a negative one is refused.
template <class Real>
struct PointBody {
  Real inverse_mass;
  Vector3<Real> velocity;
};

/// Where two bodies of a list touch. The normal points from b to a, so that n . (va - vb) > 0 parts them; it has any
/// length but 0, which is refused. So are a place that is not there, and a body that touches itself.
template <class Real>
struct BodyContact {
  Index a, b;
  Vector3<Real> normal;
};

/// What two bodies at a contact do at this moment; resting is exactly 0.
enum class ContactState { separating, resting, colliding };

/// How a body moves after an impulse.
template <class Real>
struct Motion {
  Vector3<Real> velocity, angular_velocity;
};
template <class Real>
struct Motions {
  Motion<Real> a, b;
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
