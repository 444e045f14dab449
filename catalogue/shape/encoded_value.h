// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <tuple>
#include <variant>
#include <vector>

#include "catalogue/shape/walk.h"

/// A value of any described type with its type forgotten, and back.
namespace touchstone::catalogue {

/// A part of an encoded value that is no number: an enumerator, a flag, an index, the length of a list, the choice
/// among alternatives.
using Word = std::uint32_t;

/// The one form in which questions and answers travel: numbers and words, each in canonical order. A `Shape`
/// (catalogue/shape/shape.h) says what they mean.
template <class Real>
struct EncodedValue {
  std::vector<Real> numbers;
  std::vector<Word> words;

  void clear() { numbers.clear(), words.clear(); }
  friend bool operator==(const EncodedValue&, const EncodedValue&) = default;
};

/// A question of any operation.
using Question = EncodedValue<double>;

/// A place in an encoded value from which values are read.
template <class Real>
struct Cursor {
  const Real* number;
  const Word* word;
  explicit Cursor(const EncodedValue<Real>& encoded) : number(encoded.numbers.data()), word(encoded.words.data()) {}
};

/// Appends a value to an encoded value; every number becomes a Real.
template <class Real, class T>
void pack(const T& value, EncodedValue<Real>& encoded) {
  if constexpr (is_tuple<T>) {
    spread([&](const auto&... part) { (pack(part, encoded), ...); }, value);
  } else if constexpr (Enumeration<T> || Plain<T>) {
    encoded.words.push_back(static_cast<Word>(value));
  } else if constexpr (Composite<T>) {
    with_members(value, [&](const auto&... member) { (pack(member, encoded), ...); });
  } else if constexpr (is_optional<T>) {
    encoded.words.push_back(value.has_value());
    if (value) pack(*value, encoded);
  } else if constexpr (is_vector<T>) {
    encoded.words.push_back(static_cast<Word>(value.size()));
    for (const auto& element : value) pack(element, encoded);
  } else if constexpr (is_variant<T>) {
    encoded.words.push_back(static_cast<Word>(value.index()));
    visited([&](const auto& alternative) { pack(alternative, encoded); }, value);
  } else {
    encoded.numbers.push_back(static_cast<Real>(value));
  }
}
template <class Real, class T>
EncodedValue<Real> packed_as(const T& value) {
  EncodedValue<Real> encoded;
  pack(value, encoded);
  return encoded;
}

/// The same value in doubles.
template <class T>
EncodedValue<double> packed(const T& value) {
  return packed_as<double>(value);
}

template <class... Ts, class Real, class Convert>
void unpack_alternative(std::variant<Ts...>& value, Word which, Cursor<Real>& from, const Convert& convert);

/// Reads what `pack` wrote; `convert` turns each number of the encoded value into one of the value.
template <class T, class Real, class Convert>
void unpack(T& value, Cursor<Real>& from, const Convert& convert) {
  if constexpr (is_tuple<T>) {
    spread([&](auto&... part) { (unpack(part, from, convert), ...); }, value);
  } else if constexpr (Enumeration<T> || Plain<T>) {
    value = static_cast<T>(*from.word++);
  } else if constexpr (Composite<T>) {
    with_members(value, [&](auto&... member) { (unpack(member, from, convert), ...); });
  } else if constexpr (is_optional<T>) {
    if (*from.word++ != 0) unpack(value.emplace(), from, convert);
  } else if constexpr (is_vector<T>) {
    value.resize(*from.word++);
    for (auto& element : value) unpack(element, from, convert);
  } else if constexpr (is_variant<T>) {
    unpack_alternative(value, *from.word++, from, convert);
  } else {
    value = convert(*from.number++);
  }
}
template <class... Ts, class Real, class Convert>
void unpack_alternative(std::variant<Ts...>& value, Word which, Cursor<Real>& from, const Convert& convert) {
  Word number = 0;
  ((number++ == which ? unpack(value.template emplace<Ts>(), from, convert) : void()), ...);
}

/// The number type of a described value; double where it has no numbers.
template <class T>
struct NumberTypeOf {
  using type = double;
};
template <template <class> class Shape, class Real>
requires Composite<Shape<Real>>
struct NumberTypeOf<Shape<Real>> {
  using type = Real;
};
template <Number T>
struct NumberTypeOf<T> {
  using type = T;
};
template <class T>
struct NumberTypeOf<std::vector<T>> : NumberTypeOf<T> {};
template <class T>
struct NumberTypeOf<std::optional<T>> : NumberTypeOf<T> {};
template <class T, class... Ts>
struct NumberTypeOf<std::tuple<T, Ts...>> : NumberTypeOf<T> {};
template <class T, class... Ts>
struct NumberTypeOf<std::variant<T, Ts...>> : NumberTypeOf<T> {};
template <class T>
using number_of_t = typename NumberTypeOf<T>::type;

/// Each of these has one type, so that what unpacks a shape with it is compiled once for all rows of a unit.
inline constexpr auto as_it_is = [](const auto& number) { return number; };

template <class T, class Real, class Convert>
T unpacked(const EncodedValue<Real>& encoded, const Convert& convert) {
  T value{};
  Cursor<Real> from(encoded);
  unpack(value, from, convert);
  return value;
}
template <class T>
T unpacked(const Question& encoded) {
  return unpacked<T>(encoded, as_it_is);
}

}  // namespace touchstone::catalogue
