// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/simultaneous.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// The velocities of bodies after all contacts between them were resolved at once: no contact approaches, each that did
/// leaves at e times that speed at least, and the sum of m |v' - v|^2 is the least possible.
///
/// Normals point from b to a and may have any length but 0; an inverse mass of 0 is a body that nothing moves. Whether
/// there are such velocities (`impossible`: the contacts contradict each other) is exact, and every component is the
/// double nearest to the exact one, for all finite doubles in every floating-point environment; beyond the range it is
/// infinite, and zero is +0. Time: contacts that floating-point numbers tell apart are guessed, and the guess is proved
/// by one exact solution of sparse equations; a hundred in a chain take milliseconds, and a wrong guess as much again
/// for every contact that it is wrong about. Digits grow with the contacts that hang together by bodies that can move.
/// NaN and infinities throw InvalidInput, which names the field and "finite number"; so do an inverse mass below 0
/// ("inverse mass >= 0"), a place that is not there ("index of a body"), a body that touches itself ("another body than
/// a"), a normal of length 0 ("nonzero normal") and an e out of bounds ("between 0 and 1"). Contract:
/// reference/response/simultaneous_collisions.h.
SimultaneousVelocitiesd simultaneous_collisions(const std::vector<PointBodyd>& bodies,
                                                const std::vector<BodyContactd>& contacts, double e);

}  // namespace touchstone::robust
