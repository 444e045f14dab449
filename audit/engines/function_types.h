// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>
#include <variant>

/// The signatures of an engine's member functions, as types for the compiler's messages.
namespace touchstone::audit {

/// Function types: an operation's signature, one for each alternative of its questions.
template <class... Functions>
struct Signatures {};

/// A question as its alternatives, even if there is only one.
template <class Question>
struct AlternativesOf {
  using type = std::variant<Question>;
};
template <class... Ts>
struct AlternativesOf<std::variant<Ts...>> {
  using type = std::variant<Ts...>;
};
template <class Question>
using alternatives_t = typename AlternativesOf<Question>::type;

template <class Answer, class Arguments>
struct FunctionOf;
template <class Answer, class... Ts>
struct FunctionOf<Answer, std::tuple<Ts...>> {
  using type = Answer(Ts...);
};

/// If the alternatives have answers of different types, each has its own.
template <class Answer, class Alternatives>
struct SignaturesOf;
template <class Answer, class... Ts>
struct SignaturesOf<Answer, std::variant<Ts...>> {
  using type = Signatures<typename FunctionOf<Answer, Ts>::type...>;
};
template <class... Answers, class... Ts>
requires(sizeof...(Answers) == sizeof...(Ts)) struct SignaturesOf<std::variant<Answers...>, std::variant<Ts...>> {
  using type = Signatures<typename FunctionOf<Answers, Ts>::type...>;
};
template <class Operation>
using signatures_of =
    typename SignaturesOf<typename Operation::Answer, alternatives_t<typename Operation::Question>>::type;

}  // namespace touchstone::audit
