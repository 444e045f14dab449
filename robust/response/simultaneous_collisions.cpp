// SPDX-License-Identifier: Apache-2.0
#include "robust/response/simultaneous_collisions.h"

#include <algorithm>

#include "robust/kernel/contacts/contact_system.h"
#include "robust/kernel/integers/rounding.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

void validate_simultaneous_collisions(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts,
                                      double e) {
  validation::validate_numbers("bodies", bodies), validation::validate_numbers("contacts", contacts);
  validation::validate_numbers("e", e);
  validation::validate("bodies", bodies);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (!contacts[i].rules_among(bodies.size(), validation::Asking()))
      contacts[i].rules_among(bodies.size(), validation::Refusing{validation::named("contacts", {"", i})});
  if (!kernel::valid(e, rule::restitution)) validation::validate("e", e, rule::restitution);
}

/// Turns -0 into +0.
double kept(double x) { return validation::zero(x) ? 0 : x; }

/// Applies a part's impulses to the velocities of its bodies: v + w (sum of impulses along normals).
void move(const kernel::ContactSystem& system, const kernel::Impulses& found, std::vector<Vector3d>& velocities) {
  std::map<Index, Vector3<mpz_class>> pushes;
  for (std::size_t k = 0; k < found.contacts.size(); ++k) {
    const kernel::IntegerContact& c = system.contacts[found.contacts[k]];
    const Vector3<mpz_class> push = found.numerators[k] * c.normal;
    pushes[c.a] = pushes[c.a] + push;
    pushes[c.b] = pushes[c.b] - push;
  }
  const mpz_class below = found.denominator * system.one;
  for (const auto& [body, push] : pushes) {
    const Vector3<mpz_class> above = below * system.velocities[body] + system.inverse_masses[body] * push;
    const auto rounded = [&](const mpz_class& n) { return kernel::round_quotient(n, below, system.velocity_exponent); };
    velocities[body] = {rounded(above.x), rounded(above.y), rounded(above.z)};
  }
}

}  // namespace

SimultaneousVelocitiesd simultaneous_collisions(const std::vector<PointBodyd>& bodies,
                                                const std::vector<BodyContactd>& contacts, double e) {
  validate_simultaneous_collisions(bodies, contacts, e);
  const kernel::ContactSystem system = kernel::contact_system(bodies, contacts, e);
  std::vector<Vector3d> velocities;
  for (const PointBodyd& body : bodies)
    velocities.push_back({kept(body.velocity.x), kept(body.velocity.y), kept(body.velocity.z)});
  for (const kernel::Contacts& part : kernel::connected_parts(system)) {
    const auto approaching = [&system](std::size_t i) { return sgn(system.contacts[i].wanted) > 0; };
    if (std::none_of(part.begin(), part.end(), approaching)) continue;
    const kernel::Impulses found = kernel::impulses_of(system, part, kernel::guessed(bodies, contacts, e, part));
    if (!found.possible) return {Resolution::impossible, {}};
    move(system, found, velocities);
  }
  return {Resolution::possible, std::move(velocities)};
}

}  // namespace touchstone::robust
