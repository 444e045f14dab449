// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "catalogue/families/choices.h"

/// Lists, drawn from a stream of choices.
namespace touchstone::catalogue {

/// From 1 to `most` elements, one after another ("one more?"), so that the choices of one can be cut out and leave the
/// others as they are.
template <class Draw>
auto one_by_one(Choices& choices, std::size_t most, const Draw& draw) {
  std::vector list{draw(choices)};
  while (list.size() < most && choices.below(8) != 7) list.push_back(draw(choices));
  return list;
}

/// In another order; as it is where the stream is simple.
template <class T>
std::vector<T> shuffled(std::vector<T> list, Choices& choices) {
  for (std::uint64_t more = choices.below(list.size()); more > 0; --more) {
    const std::size_t one = choices.below(list.size()), other = choices.below(list.size());
    std::swap(list[one], list[other]);
  }
  return list;
}

}  // namespace touchstone::catalogue
