// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robust/kernel/enclosed/sure.h"
#include "robust/kernel/integers/one_root.h"

namespace touchstone::robust::kernel {

/// Impulses x >= 0 with A x >= r, where each is 0 or its row holds with equality, as in contact_system.h, over numbers
/// with one root or enclosed ones: A tells how much the impulse of one contact separates another, r is the demand. Such
/// impulses exist.
template <class Number>
struct PushProgram {
  std::vector<std::vector<Number>> effects;
  std::vector<Number> wanted;
};

/// The dual active-set method of contact_system.h (Goldfarb, Idnani), started with the contacts that approach.
std::vector<OneRoot> impulses_of(const PushProgram<OneRoot>& program);
/// Throws Unsure.
std::vector<Sure> impulses_of(const PushProgram<Sure>& program);

/// The program of contacts, each of a body and another. push(contact, place) is 1, -1 or 0 times the inverse mass of
/// the body there: what the contact's impulse does to it. The parting speed, which is not positive, has to change by as
/// much as `bounce` times its size.
template <class Number, class Contact, class Push>
PushProgram<Number> push_program(const std::vector<Contact>& contacts, const Number& bounce, const Push& push) {
  PushProgram<Number> program;
  const std::size_t n = contacts.size();
  program.effects.assign(n, std::vector<Number>(n)), program.wanted.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Contact& c = contacts[i];
    for (std::size_t j = i; j < n; ++j) {
      const Number mass = push(contacts[j], c.body) - push(contacts[j], c.other);
      if (sign(mass) == 0) continue;
      program.effects[i][j] = program.effects[j][i] = mass * dot(c.normal, contacts[j].normal);
    }
    program.wanted.push_back(Number() - bounce * c.parting);
  }
  return program;
}

}  // namespace touchstone::robust::kernel
