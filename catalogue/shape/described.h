// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/members.h"
#include "geometry/polygons.h"

/// The description of a type, for programs that ask any operation: the members that a struct declares
/// (geometry/members.h), the enumerators of an enumeration, and what containers hold.
namespace touchstone::catalogue {

/// call(elements...) of a tuple, and call(alternative) of a variant. As std::apply and std::visit, but they find out
/// nothing about noexcept and make no tables of functions: a row has hundreds of such calls to compile.
template <class Call, class Tuple>
constexpr decltype(auto) spread(Call&& call, Tuple& tuple) {
  return [&]<std::size_t... i>(std::index_sequence<i...>)->decltype(auto) { return call(std::get<i>(tuple)...); }
  (std::make_index_sequence<std::tuple_size_v<std::remove_const_t<Tuple>>>());
}
template <std::size_t i = 0, class Call, class Variant>
constexpr decltype(auto) visited(Call&& call, Variant& variant) {
  if constexpr (i + 1 < std::variant_size_v<std::remove_const_t<Variant>>) {
    if (variant.index() != i) return visited<i + 1>(call, variant);
  }
  return call(*std::get_if<i>(&variant));
}

/// An enumeration with words: `words`, and `no`, the one that means "no common point" or "not in the closed shape", if
/// it has a yes-or-no reading.
template <class E>
concept Worded = requires {
  words_of(E{});
};
template <class E>
struct Words;
template <Worded E>
struct Words<E> {
  static constexpr auto words = std::to_array(words_of(E{}).words);
};
template <Worded E>
requires requires { plain_false(E{}); }
struct Words<E> {
  static constexpr auto words = std::to_array(words_of(E{}).words);
  static constexpr E no = plain_false(E{});
};

template <class T>
concept Enumeration = std::is_enum_v<T>;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// True if a value may be left out where it is read: it is optional, or all its parts are.
template <class T>
inline constexpr bool may_be_left_out = is_optional<T>;
template <class... T>
inline constexpr bool may_be_left_out<Types<T...>> = (may_be_left_out<T> && ...);
template <Composite T>
inline constexpr bool may_be_left_out<T> = may_be_left_out<member_types<T>>;

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_tuple = false;
template <class... Ts>
inline constexpr bool is_tuple<std::tuple<Ts...>> = true;

/// Alternatives of one question: in the plane or in space, of spheres or of boxes.
template <class T>
inline constexpr bool is_variant = false;
template <class... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;

/// Neither a number that is rounded nor a word: true or false, a place in a list. The same over every number type.
template <class T>
concept Plain = std::same_as<T, bool> || std::same_as<T, Index>;

/// Whatever is neither described nor an enumeration nor a container nor plain is a number.
template <class T>
concept Number =
    !Enumeration<T> && !Composite<T> && !Plain<T> && !is_optional<T> && !is_vector<T> && !is_variant<T> && !is_tuple<T>;

/// The same shape over another number type.
template <class T, class To>
struct Rebound {
  using type = To;
};
template <class T, class To>
requires(Enumeration<T> || Plain<T> || Composite<T>) struct Rebound<T, To> {
  using type = T;
};
template <template <class> class Shape, class From, class To>
requires Composite<Shape<From>>
struct Rebound<Shape<From>, To> {
  using type = Shape<To>;
};
template <class T, class To>
struct Rebound<std::optional<T>, To> {
  using type = std::optional<typename Rebound<T, To>::type>;
};
template <class T, class To>
struct Rebound<std::vector<T>, To> {
  using type = std::vector<typename Rebound<T, To>::type>;
};
template <class... Ts, class To>
struct Rebound<std::tuple<Ts...>, To> {
  using type = std::tuple<typename Rebound<Ts, To>::type...>;
};
template <class... Ts, class To>
struct Rebound<std::variant<Ts...>, To> {
  using type = std::variant<typename Rebound<Ts, To>::type...>;
};
template <class T, class To>
using rebound_t = typename Rebound<T, To>::type;

}  // namespace touchstone::catalogue
