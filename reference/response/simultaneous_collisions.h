// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/simultaneous.h"

namespace touchstone::reference {

/// The velocities of bodies after all contacts between them were resolved at once, by sequential impulses.
///
/// Deck p. 74, multiple contacts: no contact may approach afterwards, and one that did leaves at e times that speed at
/// least. With n the contact's normal, from b to a, and g = n . (va - vb), which is negative where they approach:
///     n . (va' - vb') >= e max(0, -g).
/// So a contact at rest, or parting, must not approach afterwards, and may be parted faster or slower by the others.
/// Among all velocities that do, the answer is the one of least change, the sum of m |v' - v|^2 over all bodies: a
/// quadratic program, whose answer is unique, though the impulses need not be (four legs of a table). It is what
/// impulses along the normals do that only push, and push only where the demand is met without a surplus. All contacts
/// bounce at once: of a Newton's cradle struck by one ball all others leave together; one by one they leave where one
/// pair collides after the other. Momentum is kept if no body is immovable. Energy is not gained if no contact parts
/// before, and immovable bodies stand still; nor lost then if e = 1. Where a body that parts is caught up with by what
/// bounces off a third one, these demands may take more energy than there was.
/// `possible`: these velocities. `impossible`: no velocities meet all demands. A body may be caught between immovable
/// ones that close on it, or two immovable bodies approach each other; and two contacts of the same bodies with
/// opposite normals allow no bounce.
///
/// bodies: any number, none too. inverse_mass: 0 or more, in any unit; one of 0 keeps its velocity. contacts: any
/// number; several of the same two bodies are legal. normal: of any length but 0; its length does not matter. e: from 0
/// to 1, without unit; the same for all contacts.
/// NaN or infinity: refused by robust and oracle (field "bodies[0].inverse_mass" ..., "finite number"); so are an
/// inverse mass below 0 ("inverse mass >= 0"), a place that is not there ("contacts[0].a", "index of a body"), a body
/// that touches itself ("contacts[0].b", "another body than a"), a normal of length 0 ("contacts[0].normal", "nonzero
/// normal") and an e below 0 or above 1 ("e", "between 0 and 1"). The first is named: all numbers before all else, then
/// body after body, contact after contact (its places, then its normal), and e.
///
/// Method (projected Gauss-Seidel, as engines have it): 4 sweeps over the contacts, in the order of the list; each
/// contact's impulse is made such that its own demand is met without a surplus, but not below 0. Contacts of two
/// immovable bodies are passed over. Where no body that can move is in two contacts, the first sweep gives the answer
/// and the others change nothing. Otherwise the answer is reached only in the limit: after 4 sweeps a contact may still
/// approach, and the error be as large as the speeds (cause: algorithm). It never says `impossible`.
///
/// Rounding: where every g is 0 or more as computed, the velocities stay as they are. Beyond that no bound is given but
/// the one that running error analysis finds.
/// ulps: 84 roundings behind a component of two bodies in one contact (21 a sweep: 6 for n . (va - vb), 2 for what is
/// still wanted, 7 for the share, 3 for the impulse, 3 for the velocity).
template <class Real>
SimultaneousVelocities<Real> simultaneous_collisions(const std::vector<PointBody<Real>>& bodies,
                                                     const std::vector<BodyContact<Real>>& contacts, const Real& e) {
  constexpr int sweeps = 4;
  std::vector<Vector3<Real>> v;
  for (const PointBody<Real>& body : bodies) v.push_back(body.velocity);
  const auto parting = [&v](const BodyContact<Real>& c) { return Real(dot(c.normal, v[c.a] - v[c.b])); };
  std::vector<Real> wanted, impulses(contacts.size(), Real(0));
  for (const BodyContact<Real>& c : contacts) {
    const Real speed = parting(c);
    wanted.push_back(speed < Real(0) ? Real(-Real(e * speed)) : Real(0));
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto& [a, b, n] = contacts[i];
      const Real wa = bodies[a].inverse_mass, wb = bodies[b].inverse_mass;
      const Real both = Real(wa + wb), share = Real(both * dot(n, n));
      if (!(both > Real(0))) continue;
      const Real sum = Real(impulses[i] + Real(Real(wanted[i] - parting(contacts[i])) / share));
      const Real impulse = sum > Real(0) ? sum : Real(0), change = Real(impulse - impulses[i]);
      impulses[i] = impulse;
      v[a] = v[a] + Real(wa * change) * n;
      v[b] = v[b] - Real(wb * change) * n;
    }
  }
  return {Resolution::possible, v};
}

}  // namespace touchstone::reference
