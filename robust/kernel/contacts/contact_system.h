// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "robust/kernel/contacts/definite_system.h"

/// Bodies in contact, as the quadratic program of simultaneous collisions: impulses x >= 0 with A x >= r, where each is
/// 0 or its row holds with equality. A tells how much the impulse of one contact separates another.
namespace touchstone::robust::kernel {

/// Everything is an integer: inverse masses and velocities each in their own unit, and each normal, too.
struct IntegerContact {
  Index a, b;
  Vector3<mpz_class> normal;
  mpz_class wanted;  ///< r, in units of velocity and normal over `one`
};
struct ContactSystem {
  std::vector<mpz_class> inverse_masses;
  std::vector<Vector3<mpz_class>> velocities;
  int velocity_exponent;
  mpz_class one;  ///< 1 + e is an integer in units of 1 / one
  std::vector<IntegerContact> contacts;
};
ContactSystem contact_system(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts,
                             double e);

/// Indices of contacts.
using Contacts = std::vector<std::size_t>;

/// The contacts in parts; no movable body belongs to two of them.
std::vector<Contacts> connected_parts(const ContactSystem& system);

/// Impulses over one positive denominator; `possible` is false if there are none. Contacts without an impulse are left
/// out.
struct Impulses {
  bool possible = true;
  Contacts contacts;
  std::vector<mpz_class> numerators;
  mpz_class denominator = 1;
};

/// Solves one part by a dual active-set method (Goldfarb, Idnani), exact in every step. It starts from the contacts of
/// `guess`, any subset of the part, without those that would have to pull or depend on others. If the guess is right,
/// one solution of equations proves it.
Impulses impulses_of(const ContactSystem& system, const Contacts& part, const Contacts& guess);

/// The contacts of a part that push according to floating-point arithmetic: a guess for impulses_of, right or wrong.
Contacts guessed(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts, double e,
                 const Contacts& part);

}  // namespace touchstone::robust::kernel
