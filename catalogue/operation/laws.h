// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace touchstone::catalogue {

/// Exact symmetries of an operation, as data; proptests/agreement/interrogation.cpp asks robust and the oracle for
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
  /// All lengths times 2^k, where that is exact, give the answer's lengths times 2^k (hook `scale`: what is a length).
  bool scales = false;
  std::vector<Exchange> exchanges{};
  /// Enumerators that change places where a map turns the plane over.
  std::vector<Words> reflected{};
  /// Members of the answer that are segments whose ends come in lexicographic order.
  std::vector<const char*> sorted{};
};

}  // namespace touchstone::catalogue
