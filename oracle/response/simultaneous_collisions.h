// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/simultaneous.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the optimality conditions as a linear complementarity problem - impulses and surpluses, neither negative, one
/// of the two 0 at each contact - solved exactly: where one set of impulses alone solves it, by a guess in doubles that
/// is proved, or by pivots on the diagonal; otherwise by Lemke's complementary pivoting, which would find the same. No
/// margin: how far contacts are from contradicting each other, or from no longer doing so, is not looked for. Time: of
/// n contacts n^3 operations on doubles, and elimination of sparse equations in rationals, which grow with n; where the
/// guess is wrong n^3 operations on integers; where impulses are not unique or contacts contradict each other up to
/// n^4.
///
/// Certificate: "pushes": `impulses`, one a contact, that make the velocities, and push only where the demand is met
/// without a surplus. "contradiction": `weights` of the demands, of the sum 1; what bodies can do drops out of the
/// weighted sum, and more is demanded than immovable bodies give.
template <Exact Number = double>
Truth<SimultaneousVelocities<Rational>> simultaneous_collisions(const std::vector<PointBody<Number>>& bodies,
                                                                const std::vector<BodyContact<Number>>& contacts,
                                                                const Number& e);

}  // namespace touchstone::oracle
