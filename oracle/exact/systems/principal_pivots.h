// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "oracle/exact/systems/complementary.h"

namespace touchstone::oracle {

/// The z of a problem with a unique z, if it is found by pivots on the diagonal; otherwise nullopt.
///
/// The symmetric principal pivoting method (Cottle, Pang, Stone: The Linear Complementarity Problem, section 4.2): a w
/// below 0 is raised by its own z; a variable that would fall below 0 meanwhile changes places with its complement. No
/// number that is not below 0 gets there, so that at most n of them are raised. For n contacts it takes about n pivots
/// of n^2 numbers each, minors of the matrix, where Lemke's method takes n^2 pivots along a chain. A diagonal of 0 is
/// left to that.
std::optional<Complement> single_complement(const Complementary& problem);

}  // namespace touchstone::oracle
