// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/certificates/check_space.h"

/// Bodies and their motions in the form of claims, each with the rules of its shape.
namespace touchstone::certify {

inline Triple operator+(const Triple& p, const Triple& q) { return along(p, 1, q); }
inline Triple operator*(const Rational& t, const Triple& p) { return along({0, 0, 0}, t, p); }
/// A body of positive mass.
struct Body {
  Rational mass;
  Triple velocity;
};

/// A body that may rotate, of which only the motion counts.
struct MovingBody {
  Triple position, velocity, angular_velocity;
  Triple velocity_at(const Triple& point) const { return velocity + cross(angular_velocity, point - position); }
};

/// With a positive mass and a positive definite inertia, the rows of a symmetric matrix.
struct RigidBody {
  Rational mass;
  Triple x, y, z;
  MovingBody motion;
  Triple angular_momentum(const Triple& w) const { return {dot(x, w), dot(y, w), dot(z, w)}; }
  Rational doubled_energy(const Triple& v, const Triple& w) const {
    return Rational(mass * dot(v, v) + dot(w, angular_momentum(w)));
  }
};

/// Input, by the field's name; `what` names the field in a refusal.
std::vector<Body> bodies(const json& value, const std::string& what);
RigidBody rigid_body(const json& value, const std::string& what);
MovingBody moving_body(const json& value, const std::string& what);
Triple normal(const json& value, const std::string& what);
Rational restitution(const json& value, const std::string& what);
/// `masses` and `velocities` of a claim, two of each.
std::vector<Body> two_bodies(const Claim& claim);

}  // namespace touchstone::certify
