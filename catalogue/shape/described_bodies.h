// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_shapes.h"
#include "geometry/bodies.h"

/// Bodies and their motion, as rows of `response` ask for them.
namespace touchstone::catalogue {

template <class R>
struct Described<Body<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("mass", &Body<R>::mass), member("velocity", &Body<R>::velocity)};
};
template <class R>
struct Described<Masses<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members = std::tuple{member("first", &Masses<R>::first), member("second", &Masses<R>::second)};
};
template <class R>
struct Described<Velocities<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members =
      std::tuple{member("first", &Velocities<R>::first), member("second", &Velocities<R>::second)};
};
template <class R>
struct Described<MovingBody<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("position", &MovingBody<R>::position), member("velocity", &MovingBody<R>::velocity),
                 member("angular_velocity", &MovingBody<R>::angular_velocity)};
};
template <class R>
struct Described<Inertia<R>> {
  static constexpr Form form = Form::list;
  static constexpr auto members =
      std::tuple{member("x", &Inertia<R>::x), member("y", &Inertia<R>::y), member("z", &Inertia<R>::z)};
};
template <class R>
struct Described<RigidBody<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("mass", &RigidBody<R>::mass), member("inertia", &RigidBody<R>::inertia),
                 member("position", &RigidBody<R>::position), member("velocity", &RigidBody<R>::velocity),
                 member("angular_velocity", &RigidBody<R>::angular_velocity)};
};
template <class R>
struct Described<PointBody<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("inverse_mass", &PointBody<R>::inverse_mass), member("velocity", &PointBody<R>::velocity)};
};
template <class R>
struct Described<BodyContact<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("a", &BodyContact<R>::a), member("b", &BodyContact<R>::b),
                                             member("normal", &BodyContact<R>::normal)};
};
template <class R>
struct Described<Motion<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members =
      std::tuple{member("velocity", &Motion<R>::velocity), member("angular_velocity", &Motion<R>::angular_velocity)};
};
template <class R>
struct Described<Motions<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("a", &Motions<R>::a), member("b", &Motions<R>::b)};
};

template <>
struct Words<ContactState> {
  static constexpr std::array<const char*, 3> words{"separating", "resting", "colliding"};
};

}  // namespace touchstone::catalogue
