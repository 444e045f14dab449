// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/rational_pushes.h"

#include <numeric>

#include "robust/kernel/contacts/contact_system.h"
#include "robust/kernel/integers/one_root.h"

namespace touchstone::robust::kernel {
namespace {

using Rational = mpq_class;

/// The unit in which numbers are integers: 1 over the least common multiple of their denominators.
class Unit {
 public:
  void add(const Rational& a) { mpz_lcm(parts_.get_mpz_t(), parts_.get_mpz_t(), a.get_den_mpz_t()); }
  void add(const Vector3<Rational>& v) { add(v.x), add(v.y), add(v.z); }
  mpz_class integer(const Rational& a) const { return mpz_class(a.get_num() * (parts_ / a.get_den())); }
  Vector3<mpz_class> integer(const Vector3<Rational>& v) const { return {integer(v.x), integer(v.y), integer(v.z)}; }
  const mpz_class& parts() const { return parts_; }

 private:
  mpz_class parts_ = 1;
};

Vector3d in_doubles(const Vector3<Rational>& v) { return {nearest(v.x), nearest(v.y), nearest(v.z)}; }

Contacts guess_of(const std::vector<PointBody<Rational>>& bodies, const std::vector<BodyContact<Rational>>& contacts,
                  const Rational& bounce, const Contacts& all) {
  std::vector<PointBodyd> near_bodies;
  for (const auto& [w, v] : bodies) near_bodies.push_back({nearest(w), in_doubles(v)});
  std::vector<BodyContactd> near_contacts;
  for (const auto& [a, b, n] : contacts) near_contacts.push_back({a, b, in_doubles(n)});
  return guessed(near_bodies, near_contacts, nearest(Rational(bounce - 1)), all);
}

}  // namespace

std::vector<Rational> impulses_of(const std::vector<PointBody<Rational>>& bodies,
                                  const std::vector<BodyContact<Rational>>& contacts, const Rational& bounce) {
  ContactSystem system;
  system.velocity_exponent = 0, system.one = bounce.get_den();
  Unit mass, speed;
  for (const auto& [w, v] : bodies) mass.add(w), speed.add(v);
  for (const auto& [w, v] : bodies)
    system.inverse_masses.push_back(mass.integer(w)), system.velocities.push_back(speed.integer(v));
  std::vector<mpz_class> parts_of_length;
  for (const auto& [a, b, n] : contacts) {
    Unit length;
    length.add(n), parts_of_length.push_back(length.parts());
    Vector3<mpz_class> normal = length.integer(n);
    mpz_class wanted = dot(normal, system.velocities[b] - system.velocities[a]) * bounce.get_num();
    system.contacts.push_back({a, b, std::move(normal), std::move(wanted)});
  }
  Contacts all(contacts.size());
  std::iota(all.begin(), all.end(), 0);
  const Impulses found = impulses_of(system, all, guess_of(bodies, contacts, bounce, all));
  const mpz_class below = found.denominator * system.one * speed.parts();
  std::vector<Rational> result(contacts.size());
  for (std::size_t k = 0; k < found.contacts.size(); ++k) {
    const std::size_t contact = found.contacts[k];
    Rational& impulse = result[contact];
    impulse = Rational(found.numerators[k] * mass.parts() * parts_of_length[contact], below);
    impulse.canonicalize();
  }
  return result;
}

}  // namespace touchstone::robust::kernel
