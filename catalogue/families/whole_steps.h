// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/families/numbers.h"
#include "geometry/space.h"

/// Displacements of integer length, drawn from a draw stream.
namespace touchstone::catalogue {

/// The displacement from one position to another, its length where that is an integer, and whether all is in the plane.
struct Step {
  Vector3d displacement;
  double length;
  bool in_plane;
};

/// By a Pythagorean triple or, in space, quadruple.
inline Step integer_step(DrawStream& draws) {
  static constexpr std::array<std::array<double, 4>, 9> steps{{{3, 4, 0, 5},
                                                               {1, 0, 0, 1},
                                                               {5, -12, 0, 13},
                                                               {119, 120, 0, 169},
                                                               {1, 2, 2, 3},
                                                               {2, -3, 6, 7},
                                                               {4, 4, 7, 9},
                                                               {0, 8, 15, 17},
                                                               {2, 10, 11, 15}}};
  const bool in_plane = draws.coin();
  const auto [x, y, z, length] = steps[draws.below(in_plane ? 4 : 9)];
  const double k = one_to(draws, 1 << 12);
  return {{k * x, k * y, k * z}, k * length, in_plane};
}

}  // namespace touchstone::catalogue
