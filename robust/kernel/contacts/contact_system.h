// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "robust/kernel/contacts/definite_system.h"

/// Bodies that touch, as the quadratic program of simultaneous collisions: impulses x >= 0 with A x >= r, each 0 or its
/// row met without a surplus. A is how the impulse of one contact parts another.
namespace touchstone::robust::kernel {

/// All on integers: inverse masses and velocities each in a unit of their own, each normal too.
struct WholeContact {
  Index a, b;
  Vector3<mpz_class> normal;
  mpz_class wanted;  ///< r, in units of velocity and normal over `one`
};
struct ContactSystem {
  std::vector<mpz_class> inverse_masses;
  std::vector<Vector3<mpz_class>> velocities;
  int velocity_exponent;
  mpz_class one;  ///< 1 + e is an integer in units of 1 / one
  std::vector<WholeContact> contacts;
};
ContactSystem contact_system(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts,
                             double e);

/// Places of contacts.
using Contacts = std::vector<std::size_t>;

/// The contacts in parts, none of which shares a body that can move with another.
std::vector<Contacts> connected_parts(const ContactSystem& system);

/// Impulses over one denominator, which is positive; or possible is false. Contacts without an impulse are left out.
struct Impulses {
  bool possible = true;
  Contacts contacts;
  std::vector<mpz_class> numerators;
  mpz_class denominator = 1;
};

/// What solves one part: a dual active-set method (Goldfarb, Idnani), exact in every step. It starts from the contacts
/// of `guess`, any of the part, less those that would have to pull or depend on others. If the guess is right, one
/// solution of equations proves it.
Impulses impulses_of(const ContactSystem& system, const Contacts& part, const Contacts& guess);

/// The contacts of a part that push, as far as floating-point numbers tell: right or not, for impulses_of.
Contacts guessed(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts, double e,
                 const Contacts& part);

}  // namespace touchstone::robust::kernel
