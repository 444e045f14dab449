// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace touchstone::catalogue {

/// The order of lists, for sets and maps of them. The operator < of vectors is wrong for unsigned numbers where the most
/// significant byte comes first, up to libstdc++ 12.3 and 13.2 (its PR 113960): it compares too few bytes.
struct Lexicographic {
  template <class List>
  bool operator()(const List& a, const List& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  }
};

}  // namespace touchstone::catalogue
