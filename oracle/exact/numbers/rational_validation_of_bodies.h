// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation_of_bodies.h"
#include "oracle/exact/numbers/rational_validation.h"

/// Validation of bodies in rationals: the rules of geometry/validation_of_bodies.h.
namespace touchstone::validation {

inline void validate(const std::string& field, const Body<oracle::Rational>& body) {
  require_positive_mass(sgn(body.mass) > 0, field + ".mass");
}
inline void validate(const std::string& field, const Masses<oracle::Rational>& masses) {
  require_positive_mass(sgn(masses.first) > 0, field + "[0]");
  require_positive_mass(sgn(masses.second) > 0, field + "[1]");
}
inline void validate(const std::string&, const Velocities<oracle::Rational>&) {}
inline void validate_restitution(const std::string& field, const oracle::Rational& e) {
  require_restitution(!negative(e) && e <= 1, field);
}
inline void validate(const std::string&, const MovingBody<oracle::Rational>&) {}
/// Decides by the leading minors.
inline void validate(const std::string& field, const Inertia<oracle::Rational>& i) {
  require_symmetry(i.x.y == i.y.x, i.x.z == i.z.x, i.y.z == i.z.y, field);
  const oracle::Rational second = i.x.x * i.y.y - i.x.y * i.y.x;
  if (sgn(i.x.x) <= 0 || sgn(second) <= 0 || sgn(dot(cross(i.x, i.y), i.z)) <= 0) refuse_indefinite(field);
}
inline void validate(const std::string& field, const RigidBody<oracle::Rational>& body) {
  validate(field + ".inertia", body.inertia), require_positive_mass(sgn(body.mass) > 0, field + ".mass");
}
inline void validate(const std::string& field, const PointBody<oracle::Rational>& body) {
  require_inverse_mass(!negative(body.inverse_mass), field + ".inverse_mass");
}
inline void validate(const std::string& field, const BodyContact<oracle::Rational>& contact) {
  validate_normal(field + ".normal", contact.normal);
}

}  // namespace touchstone::validation
