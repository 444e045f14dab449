// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "catalogue/families/draw_stream.h"

/// Lists, drawn from a draw stream.
namespace touchstone::catalogue {

/// From 1 to `most` elements, one after another ("one more?"), so that the draws of one can be cut out and leave the
/// others as they are.
template <class Draw>
auto one_by_one(DrawStream& draws, std::size_t most, const Draw& draw) {
  std::vector list{draw(draws)};
  while (list.size() < most && draws.below(8) != 7) list.push_back(draw(draws));
  return list;
}

/// The same, and each is the last once in `odds`.
template <class Draw>
auto until(DrawStream& draws, std::size_t most, std::uint64_t odds, const Draw& draw) {
  std::vector list{draw(draws)};
  while (list.size() < most && draws.below(odds) != 0) list.push_back(draw(draws));
  return list;
}

/// Lists that outgrow arrays of a fixed length and counters of 4, 6 or 8 bits: every second has more than 16 elements,
/// every tenth more than 64, one in 32 more than 256, as far as `most` lets them; more would be dear. One after another
/// ("one more?"); of one element where the stream is simple.
template <class Draw>
auto long_list(DrawStream& draws, const Draw& draw, std::size_t most = 300) {
  const std::uint64_t size = draws.below(32);
  const std::size_t least = size < 16 ? 0 : size < 29 ? 16 : size < 31 ? 64 : 256;
  std::vector list{draw(draws)};
  for (bool more = true; more && list.size() < most;) {
    more = draws.below(4) != 0 || list.size() <= least;
    if (more) list.push_back(draw(draws));
  }
  return list;
}

/// The index of an element of a list, one of the last for the most part: what a loop that ends too early leaves out.
inline std::size_t late_index(std::size_t size, DrawStream& draws) {
  const std::size_t from_end = draws.one_in(4) ? draws.below(size) : draws.below(3);
  return size - 1 - std::min(from_end, size - 1);
}

/// One to `most` of them once more, at the end.
template <class T>
std::vector<T> with_repeated(std::vector<T> list, std::uint64_t most, DrawStream& draws) {
  for (std::uint64_t more = 1 + draws.below(most); more > 0; --more) {
    const T again = list[draws.below(list.size())];
    list.push_back(again);
  }
  return list;
}

/// In another order; as it is where the stream is simple.
template <class T>
std::vector<T> shuffled(std::vector<T> list, DrawStream& draws) {
  for (std::uint64_t more = draws.below(list.size()); more > 0; --more) {
    const std::size_t one = draws.below(list.size()), other = draws.below(list.size());
    std::swap(list[one], list[other]);
  }
  return list;
}

}  // namespace touchstone::catalogue
