// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// Which stage decided, in the order in which they are asked.
///
/// filter:  a few floating-point operations and a proved bound (robust/kernel/filters.h); may not know.
/// lattice: the input as integers below 2^61 on one common power of two, products in 128 bits; may not fit.
/// exact:   the input as integers of any size; CGAL over GMP integers. Always knows.
///
/// Every operation X follows one pattern. X_filter and X_lattice return std::optional, empty for "ask the next";
/// X_exact always answers; X(..., Stage& decided) asks them in order and says who answered. The stage functions expect
/// valid input; X itself refuses other input. Where X also returns numbers, X_relation is the decision
/// alone.
enum class Stage { filter, lattice, exact };

}  // namespace touchstone::robust
