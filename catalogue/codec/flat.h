// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "catalogue/codec/walk.h"

/// A question as one row of numbers, each list preceded by its length, and back.
namespace touchstone::audit {

template <class Asked>
void flatten(const Asked& asked, std::vector<double>& numbers) {
  numbers.clear();
  walk(
      asked, [&](const auto& number) { numbers.push_back(static_cast<double>(number)); },
      [&](const auto& list) { numbers.push_back(static_cast<double>(list.size())); });
}
template <class Asked>
std::vector<double> flattened(const Asked& asked) {
  std::vector<double> numbers;
  flatten(asked, numbers);
  return numbers;
}

/// Missing numbers are 0; no list is longer than there are numbers left.
template <class Asked>
Asked unflattened(const std::vector<double>& numbers) {
  Asked asked{};
  std::size_t i = 0;
  const auto next = [&] { return i < numbers.size() ? numbers[i++] : 0.0; };
  walk(
      asked, [&](auto& number) { number = static_cast<std::remove_reference_t<decltype(number)>>(next()); },
      [&](auto& list) {
        const double length = next();
        const auto left = static_cast<double>(numbers.size() - i);
        list.resize(length > 0 ? static_cast<std::size_t>(std::min(length, left)) : 0);  // NaN: 0
      });
  return asked;
}

/// Every number 0, every list of that length.
template <class Asked>
Asked zeros(std::size_t length) {
  Asked asked{};
  walk(
      asked, [](auto& number) { number = 0; }, [&](auto& list) { list.resize(length); });
  return asked;
}

/// Where the coordinates of a question stand in its row of numbers: everything but the lengths.
template <class Asked>
std::vector<std::size_t> coordinates_of(const Asked& asked) {
  std::vector<std::size_t> places;
  std::size_t i = 0;
  walk(
      asked, [&](const auto&) { places.push_back(i++); }, [&](const auto&) { ++i; });
  return places;
}

template <class Asked>
bool holds_lists() {
  bool found = false;
  const Asked asked{};
  walk(
      asked, [](const auto&) {}, [&](const auto&) { found = true; });
  return found;
}

}  // namespace touchstone::audit
