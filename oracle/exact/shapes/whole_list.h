// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {

/// The numbers of a list of any length as integers times one positive unit: number i is whole[i] units.
struct IntegerList {
  std::vector<Integer> integers;
  Rational unit;

  /// value * unit^degree
  Rational actual(Rational value, int degree) const {
    for (int i = 0; i < degree; ++i) value *= unit;
    return value;
  }
};

IntegerList integer_list(const std::vector<double>& numbers);
IntegerList integer_list(const std::vector<Rational>& numbers);

}  // namespace touchstone::oracle
