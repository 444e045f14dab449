// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// How a struct declares its members, once and in its own body:
///
///   static constexpr auto members = as_record("center", "radius").of(Meaning::length);
///
/// and its rules, if it has any but that its numbers are finite (geometry/rules.h). From these follow validation, JSON,
/// encoded values, conversion to other number types and comparison.
namespace touchstone {

/// How JSON writes a struct. A list is an array in the order of the members; a record is an object; what is bare is
/// written as its only member. A mesh is an object of `vertices` and `faces`: where it has polygons, these are its
/// faces, and its triangles are `cut` (catalogue/codec/mesh_json.h).
enum class Form { list, record, bare, mesh };

/// The meaning of a number.
enum class Meaning {
  number,     ///< nothing but itself: a parameter, a ratio
  place,      ///< a coordinate of a position
  direction,  ///< a coordinate of a displacement
  length,
};

/// A part of a field: ".name[i][j]", without what is left out.
struct Where {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const char* name;
  std::size_t i, j;
  constexpr Where(const char* of, std::size_t at = none, std::size_t then = none) : name(of), i(at), j(then) {}
};

/// The names of a struct's members in their order, and what its own numbers mean.
template <std::size_t size>
struct Members {
  static constexpr std::size_t count = size;
  Form form;
  const char* names[size];
  Meaning meaning = Meaning::number;

  constexpr Members of(Meaning own) const {
    Members members = *this;
    members.meaning = own;
    return members;
  }
  constexpr Where at(std::size_t member) const {
    if (form == Form::list) return {"", member};
    return {form == Form::bare ? "" : names[member]};
  }
};
template <class... Name>
constexpr Members<sizeof...(Name)> as_list(Name... names) {
  return {Form::list, {names...}};
}
template <class... Name>
constexpr Members<sizeof...(Name)> as_record(Name... names) {
  return {Form::record, {names...}};
}
constexpr Members<1> as_bare(const char* name) { return {Form::bare, {name}}; }

/// The words of an enumeration in JSON, in the order of its enumerators; declared next to it:
///
///   constexpr auto words_of(Side) { return as_words("left", "on", "right"); }
template <std::size_t count>
struct WordList {
  const char* words[count];
};
template <class... Word>
constexpr WordList<sizeof...(Word)> as_words(Word... words) {
  return {{words...}};
}

/// A struct that declares its members.
template <class T>
concept Composite = requires {
  T::members.form;
};

/// call(members...) of a value, in their order.
template <class T, class Call>
constexpr decltype(auto) with_members(T& value, const Call& call) {
  constexpr std::size_t count = T::members.count;
  static_assert(count <= 5 || count == 20);
  if constexpr (count == 1) {
    auto& [a] = value;
    return call(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = value;
    return call(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = value;
    return call(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = value;
    return call(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = value;
    return call(a, b, c, d, e);
  } else {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t] = value;
    return call(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t);
  }
}

/// The types of a struct's members, in their order.
template <class... T>
struct Types {};
struct TypesOf {
  template <class... T>
  Types<T...> operator()(T&...) const;
};
template <Composite T>
using member_types = decltype(with_members(*static_cast<T*>(nullptr), TypesOf()));

}  // namespace touchstone
