// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace touchstone::catalogue {

/// Exact symmetries of an operation, as data; proptests/agreement/interrogation.cpp tests robust and the oracle for
/// them.
struct Laws {
  /// Maps of the plane or of space: the image of a question has the image of its answer. Positions and displacements
  /// are mapped, lengths take the map's factor, other numbers stay.
  enum class Maps {
    none,
    axes,          ///< the symmetries of the axes: exact for every double
    similarities,  ///< also integer similarities of lattice questions
    affine,        ///< also integer affine maps of lattice questions
  };
  /// Two arguments that may be exchanged, and the members of the answer that are exchanged with them.
  struct Exchange {
    std::size_t first, second;
    std::vector<std::pair<const char*, const char*>> members{};
  };
  using Words = std::pair<const char*, const char*>;

  Maps maps = Maps::none;
  /// Multiplying all lengths by 2^k, if that is exact, multiplies the answer's lengths by 2^k (hook `scale` tells
  /// lengths).
  bool scales = false;
  std::vector<Exchange> exchanges{};
  /// Enumerators that are exchanged if a map reverses the orientation of the plane.
  std::vector<Words> reflected{};
  /// Members of the answer that are segments whose ends are in lexicographic order.
  std::vector<const char*> sorted{};
};

}  // namespace touchstone::catalogue
