// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "catalogue/row.h"
#include "catalogue/families/families.h"

namespace touchstone::audit {

/// SplitMix64's output function, as in Choices.
inline std::uint64_t scattered(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The inner loop of an exhaustive run of decisions. Row::decision has two functions: robust(Question) on doubles and
/// oracle(the same shapes over std::int64_t).
template <class Row>
DecisionCount count_decisions_of(int size, std::uint64_t first, std::uint64_t last) {
  using Asked = typename Row::Question;
  Asked asked = zeros<Asked>(Row::card().list_length);
  auto integers = zeros<rebound_t<Asked, std::int64_t>>(Row::card().list_length);
  std::vector<double*> numbers;
  std::vector<std::int64_t*> digits;
  for_each_number(asked, [&](double& number) { numbers.push_back(&number); });
  for_each_number(integers, [&](std::int64_t& number) { digits.push_back(&number); });
  std::uint64_t rest = first;
  for (std::size_t i = digits.size(); i-- > 0; rest /= static_cast<std::uint64_t>(size)) {
    *digits[i] = static_cast<std::int64_t>(rest % static_cast<std::uint64_t>(size));
    *numbers[i] = static_cast<double>(*digits[i]);
  }
  using Decision = decltype(Row::decision::robust(asked));
  std::array<std::uint64_t, Words<Decision>::words.size()> outcomes{};
  DecisionCount count;
  for (std::uint64_t index = first; index < last; ++index) {
    const Decision truth = Row::decision::oracle(integers);
    const auto word = static_cast<std::size_t>(truth);
    ++outcomes[word];
    count.hash += scattered(index * 4 + word);
    if (Row::decision::robust(asked) != truth && count.wrong++ == 0) count.first_wrong = index;
    for (std::size_t i = digits.size(); i-- > 0;) {
      if (++*digits[i] < size) {
        *numbers[i] = static_cast<double>(*digits[i]);
        break;
      }
      *digits[i] = 0;
      *numbers[i] = 0;
    }
  }
  count.cases = last - first;
  for (std::size_t i = 0; i < outcomes.size(); ++i) count.outcomes[Words<Decision>::words[i]] = outcomes[i];
  return count;
}

}  // namespace touchstone::audit
