// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "catalogue/operation/operation.h"

namespace touchstone::program {

/// Prints the tables "shape against shape" of docs/operations.md: which operation takes two shapes.
void print_shape_pairs(std::ostream& out);

}  // namespace touchstone::program
