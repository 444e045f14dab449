// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace touchstone::program {

/// From now on GMP throws std::bad_alloc where it finds no memory, and does not end the program.
void have_gmp_throw();

}  // namespace touchstone::program
