// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described.h"

/// Walks over described values: every number in canonical order, and the same value over another number type.
namespace touchstone::catalogue {

/// visit(number) for every number, and before the elements of a list visit_list(list), which may change its length.
template <class T, class Visit, class VisitList>
void walk(T& value, const Visit& visit, const VisitList& visit_list) {
  using Bare = std::remove_const_t<T>;
  if constexpr (Enumeration<Bare> || Plain<Bare>) {
    return;
  } else if constexpr (Composite<Bare>) {
    with_members(value, [&](auto&... member) { (walk(member, visit, visit_list), ...); });
  } else if constexpr (is_optional<Bare>) {
    if (value) walk(*value, visit, visit_list);
  } else if constexpr (is_vector<Bare>) {
    visit_list(value);
    for (auto& element : value) walk(element, visit, visit_list);
  } else if constexpr (is_tuple<Bare>) {
    spread([&](auto&... part) { (walk(part, visit, visit_list), ...); }, value);
  } else if constexpr (is_variant<Bare>) {
    visited([&](auto& alternative) { walk(alternative, visit, visit_list); }, value);
  } else {
    visit(value);
  }
}

template <class T, class Visit>
void for_each_number(T& value, const Visit& visit) {
  walk(value, visit, [](auto&) {});
}

/// The same value over the number type To, each number passed through `change`.
template <class To, class T, class Change>
rebound_t<T, To> converted(const T& value, const Change& change) {
  if constexpr (Enumeration<T> || Plain<T>) {
    return value;
  } else if constexpr (Composite<T>) {
    rebound_t<T, To> result{};
    with_members(value, [&](const auto&... from) {
      with_members(result, [&](auto&... to) { ((to = converted<To>(from, change)), ...); });
    });
    return result;
  } else if constexpr (is_optional<T>) {
    if (!value) return std::nullopt;
    return converted<To>(*value, change);
  } else if constexpr (is_vector<T>) {
    rebound_t<T, To> result;
    result.reserve(value.size());
    for (const auto& element : value) result.push_back(converted<To>(element, change));
    return result;
  } else if constexpr (is_tuple<T>) {
    return spread([&](const auto&... part) { return rebound_t<T, To>{converted<To>(part, change)...}; }, value);
  } else if constexpr (is_variant<T>) {
    return visited([&](const auto& alternative) { return rebound_t<T, To>(converted<To>(alternative, change)); },
                   value);
  } else {
    return change(value);
  }
}

}  // namespace touchstone::catalogue
