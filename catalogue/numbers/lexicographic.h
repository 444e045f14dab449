// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace touchstone::catalogue {

/// The order of lists, for sets and maps of them. In C++20 the operator < of vectors in libstdc++ 12.2 is wrong for
/// unsigned numbers where the most significant byte comes first: {0, 1, 5} is not less than {0, 1, 7} there.
struct Lexicographic {
  template <class List>
  bool operator()(const List& a, const List& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

}  // namespace touchstone::catalogue
