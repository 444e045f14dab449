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

inline void validate(const std::string& field, const Bodyd& body) {
  validate(field + ".mass", body.mass), validate(field + ".velocity", body.velocity);
  require_positive_mass(positive(body.mass), field + ".mass");
}
inline void validate(const std::string& field, const Massesd& masses) {
  validate(field + "[0]", masses.first), validate(field + "[1]", masses.second);
  require_positive_mass(positive(masses.first), field + "[0]");
  require_positive_mass(positive(masses.second), field + "[1]");
}
inline void validate(const std::string& field, const Velocitiesd& velocities) {
  validate(field + "[0]", velocities.first), validate(field + "[1]", velocities.second);
}
/// The coefficient of restitution.
inline void validate_restitution(const std::string& field, double e) {
  validate(field, e);
  require_restitution(!negative(e) && in_order(e, 1), field);
}
inline void validate(const std::string& field, const MovingBodyd& body) {
  validate(field + ".position", body.position), validate(field + ".velocity", body.velocity);
  validate(field + ".angular_velocity", body.angular_velocity);
}
inline void validate(const std::string& field, const Inertiad& inertia) {
  validate(field + "[0]", inertia.x), validate(field + "[1]", inertia.y), validate(field + "[2]", inertia.z);
  require_symmetry(same(inertia.x.y, inertia.y.x), same(inertia.x.z, inertia.z.x), same(inertia.y.z, inertia.z.y),
                   field);
}
/// Whether the inertia is positive definite is decided where minors are exact.
inline void validate(const std::string& field, const RigidBodyd& body) {
  validate(field + ".mass", body.mass), validate(field + ".inertia", body.inertia);
  validate(field + ".position", body.position), validate(field + ".velocity", body.velocity);
  validate(field + ".angular_velocity", body.angular_velocity);
  require_positive_mass(positive(body.mass), field + ".mass");
}
inline void validate(const std::string& field, const PointBodyd& body) {
  validate(field + ".inverse_mass", body.inverse_mass), validate(field + ".velocity", body.velocity);
  require_inverse_mass(!negative(body.inverse_mass), field + ".inverse_mass");
}
inline void validate(const std::string& field, const BodyContactd& contact) {
  validate_normal(field + ".normal", contact.normal);
}

}  // namespace touchstone::validation
