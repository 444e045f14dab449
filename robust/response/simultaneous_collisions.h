// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/simultaneous.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// The velocities of bodies after all contacts between them were resolved at once: no contact approaches, each that did
/// separates at e times that speed at least, and the sum of m |v' - v|^2 is the least possible.
///
/// Normals point from b to a and may have any length but 0; an inverse mass of 0 means an immovable body. The existence
/// of such velocities (`impossible`: the contacts contradict each other) is decided exactly, and every component is the
/// double nearest to the exact one, for all finite doubles in every floating-point environment; beyond the range it is
/// infinite, and zero is +0. Time: floating-point numbers guess the pushing contacts, and one exact solution of sparse
/// equations proves the guess; a hundred in a chain take milliseconds, and a wrong guess as much again for every
/// contact that it is wrong about. Digits grow with the number of contacts connected by movable bodies. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do an inverse mass below 0 ("inverse
/// mass >= 0"), an index without a body ("index of a body"), a body that touches itself ("another body than a"), a
/// normal of length 0 ("nonzero normal") and an e out of bounds ("between 0 and 1"). Contract:
/// reference/response/simultaneous_collisions.h.
SimultaneousVelocitiesd simultaneous_collisions(const std::vector<PointBodyd>& bodies,
                                                const std::vector<BodyContactd>& contacts, double e);

}  // namespace touchstone::robust
