// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "catalogue/operation/row.h"
#include "catalogue/shape/encoded_value.h"
#include "proptests/answer_bits.h"

/// What robust answers in any environment, bit by bit.
namespace touchstone::proptests {

template <class T>
void append_bits(const T& value, std::vector<std::uint64_t>& words) {
  if constexpr (catalogue::Enumeration<T>) {
    words.push_back(static_cast<std::uint64_t>(value));
  } else if constexpr (Composite<T>) {
    with_members(value, [&](const auto&... member) { (append_bits(member, words), ...); });
  } else if constexpr (catalogue::is_optional<T>) {
    words.push_back(value.has_value());
    if (value) append_bits(*value, words);
  } else if constexpr (catalogue::Plain<T>) {
    words.push_back(value);
  } else if constexpr (catalogue::is_vector<T>) {
    words.push_back(value.size());
    for (const auto& element : value) append_bits(element, words);
  } else if constexpr (catalogue::is_variant<T>) {
    words.push_back(value.index());
    std::visit([&words](const auto& alternative) { append_bits(alternative, words); }, value);
  } else {
    words.push_back(std::bit_cast<std::uint64_t>(value));
  }
}

/// The question with its types.
template <class Row>
typename Row::Question typed(const catalogue::Question& question) {
  return catalogue::unpacked<typename Row::Question>(question);
}

/// What robust answers in an environment; then its decision alone, where it has one.
template <class Row>
AnswerBits robust_bits(const catalogue::Question& question, std::size_t environment) {
  const auto asked = typed<Row>(question);
  AnswerBits bits;
  try {
    const auto ask = [](const auto& argument) { return catalogue::ask_robust<Row>(argument); };
    append_bits(in_environment(environment, asked, ask), bits.words);
    if constexpr (requires { Row::decision::robust(asked); }) {
      const auto decide = [](const auto& argument) { return Row::decision::robust(argument); };
      append_bits(in_environment(environment, asked, decide), bits.words);
    }
  } catch (const InvalidInput& refused) {
    bits.refused = refused.what();
  }
  return bits;
}

}  // namespace touchstone::proptests
