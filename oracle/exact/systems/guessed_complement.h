// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/systems/complementary.h"

namespace touchstone::oracle {

/// The z of a problem with a unique z, if floating-point numbers guess which of its numbers are not 0; otherwise
/// nullopt.
///
/// The guess: the pivots of principal_pivots.h in doubles. Its proof: elimination of the equations of these numbers in
/// rationals, of which those that are 0 cost nothing, then z >= 0 and w >= 0 at all contacts; and that the equations of
/// all contacts where w is 0 have one solution, so that there is no other z. For n contacts in a row it takes n^3
/// operations on doubles, and n on rationals whose digits grow with n.
std::optional<Complement> guessed_complement(const Complementary& problem);

}  // namespace touchstone::oracle
