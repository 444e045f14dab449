// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/validation.h"

/// Validation of bodies and of what happens to them: see validation.h.
namespace touchstone::validation {

/// The rules, for doubles and for rationals alike.
inline void require(bool holds, const std::string& field, const char* rule) {
  if (!holds) throw InvalidInput(field, rule);
}
inline void require_positive_mass(bool holds, const std::string& field) { require(holds, field, "mass > 0"); }
inline void require_inverse_mass(bool holds, const std::string& field) { require(holds, field, "inverse mass >= 0"); }
inline void require_restitution(bool holds, const std::string& field) { require(holds, field, "between 0 and 1"); }
inline void require_symmetry(bool xy, bool xz, bool yz, const std::string& field) {
  require(xy, field + "[1][0]", "symmetric");
  require(xz, field + "[2][0]", "symmetric");
  require(yz, field + "[2][1]", "symmetric");
}
/// Where minors are exact.
[[noreturn]] inline void refuse_indefinite(const std::string& field) { throw InvalidInput(field, "positive definite"); }
template <class Real>
void validate_bodies_of(const std::string& field, const BodyContact<Real>& contact, std::size_t bodies) {
  require(contact.a < bodies, field + ".a", "index of a body");
  require(contact.b < bodies, field + ".b", "index of a body");
  require(contact.a != contact.b, field + ".b", "another body than a");
}

inline bool positive(double value) { return !zero(value) && !negative(value); }

inline void validate_numbers(const std::string& field, const Bodyd& body) {
  validate_numbers(field + ".mass", body.mass), validate_numbers(field + ".velocity", body.velocity);
}
inline void validate_numbers(const std::string& field, const Massesd& masses) {
  validate_numbers(field + "[0]", masses.first), validate_numbers(field + "[1]", masses.second);
}
inline void validate_numbers(const std::string& field, const Velocitiesd& velocities) {
  validate_numbers(field + "[0]", velocities.first), validate_numbers(field + "[1]", velocities.second);
}
inline void validate_numbers(const std::string& field, const MovingBodyd& body) {
  validate_numbers(field + ".position", body.position), validate_numbers(field + ".velocity", body.velocity);
  validate_numbers(field + ".angular_velocity", body.angular_velocity);
}
inline void validate_numbers(const std::string& field, const Inertiad& inertia) {
  validate_numbers(field + "[0]", inertia.x), validate_numbers(field + "[1]", inertia.y);
  validate_numbers(field + "[2]", inertia.z);
}
inline void validate_numbers(const std::string& field, const RigidBodyd& body) {
  validate_numbers(field + ".mass", body.mass), validate_numbers(field + ".inertia", body.inertia);
  validate_numbers(field + ".position", body.position), validate_numbers(field + ".velocity", body.velocity);
  validate_numbers(field + ".angular_velocity", body.angular_velocity);
}
inline void validate_numbers(const std::string& field, const PointBodyd& body) {
  validate_numbers(field + ".inverse_mass", body.inverse_mass), validate_numbers(field + ".velocity", body.velocity);
}
inline void validate_numbers(const std::string& field, const BodyContactd& contact) {
  validate_numbers(field + ".normal", contact.normal);
}

inline void validate(const std::string& field, const Bodyd& body) {
  validate_numbers(field, body), require_positive_mass(positive(body.mass), field + ".mass");
}
inline void validate(const std::string& field, const Massesd& masses) {
  validate_numbers(field, masses);
  require_positive_mass(positive(masses.first), field + "[0]");
  require_positive_mass(positive(masses.second), field + "[1]");
}
inline void validate(const std::string& field, const Velocitiesd& velocities) { validate_numbers(field, velocities); }
/// The coefficient of restitution.
inline void validate_restitution(const std::string& field, double e) {
  validate_numbers(field, e);
  require_restitution(!negative(e) && in_order(e, 1), field);
}
inline void validate(const std::string& field, const MovingBodyd& body) { validate_numbers(field, body); }
inline void validate(const std::string& field, const Inertiad& inertia) {
  validate_numbers(field, inertia);
  require_symmetry(same(inertia.x.y, inertia.y.x), same(inertia.x.z, inertia.z.x), same(inertia.y.z, inertia.z.y),
                   field);
}
/// Whether the inertia is positive definite is decided where minors are exact.
inline void validate(const std::string& field, const RigidBodyd& body) {
  validate_numbers(field, body), validate(field + ".inertia", body.inertia);
  require_positive_mass(positive(body.mass), field + ".mass");
}
inline void validate(const std::string& field, const PointBodyd& body) {
  validate_numbers(field, body), require_inverse_mass(!negative(body.inverse_mass), field + ".inverse_mass");
}
inline void validate(const std::string& field, const BodyContactd& contact) {
  validate_normal(field + ".normal", contact.normal);
}

}  // namespace touchstone::validation
