// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>
#include <variant>

#include "catalogue/shape/encoded_value.h"
#include "geometry/answers.h"

/// A signature is a struct named like its operation, in the file of that name. It says what an engine's member function
/// of the operation takes and returns, and no more, so that an engine compiles fast. It holds
///   TOUCHSTONE_SIGNATURE(op)     the name, and how an engine is asked; where a question's alternatives have answers of
///                                different types: TOUCHSTONE_SIGNATURE_EITHER(op), and before it
///                                template <class R> using Answers = std::variant<Aabb2<R>, Aabb3<R>>
/// and derives from Signature<Answer(Argument...)>, over double; or, where a question has alternatives, it holds
///   using Question = std::variant<...>;   of tuples of arguments
///   using Answer = ...;
/// The operation's row (catalogue/operation/row.h) derives from it.
#define TOUCHSTONE_SIGNATURE(op)                                            \
  TOUCHSTONE_NAME(op)                                                       \
  template <class E>                                                        \
  static auto ask(E& engine, const auto&... q)->decltype(engine.op(q...)) { \
    return engine.op(q...);                                                 \
  }
#define TOUCHSTONE_SIGNATURE_EITHER(op)                                                      \
  TOUCHSTONE_NAME(op)                                                                        \
  template <class E>                                                                         \
  static auto ask(E& engine, const auto&... q)->decltype(either<Answers>(engine.op(q...))) { \
    return either<Answers>(engine.op(q...));                                                 \
  }
/// In a class derived from the engine and from Namesake the operation's name is ambiguous if the engine has a member of
/// that name, whatever its arguments are.
#define TOUCHSTONE_NAME(op)                                                                               \
  static constexpr const char* name = #op;                                                                \
  struct Namesake {                                                                                       \
    int op;                                                                                               \
  };                                                                                                      \
  template <class Both>                                                                                   \
  static constexpr bool is_ambiguous = !requires {                                                        \
    &Both::op;                                                                                            \
  };                                                                                                      \
  template <bool has_signature, class... Expected>                                                        \
  static constexpr void require_signature() {                                                             \
    static_assert(has_signature,                                                                          \
                  "the engine's member " #op " cannot be called with the arguments of the operation " #op \
                  ": the signature expected stands beside require_signature in this message, and in "     \
                  "docs/operations.md");                                                                  \
  }

namespace touchstone::catalogue {

/// An answer to one alternative of a question as one of the answers to all of them.
template <template <class> class Answers, class Answer>
Answers<number_of_t<Answer>> either(const Answer& answer) {
  static_assert(std::is_convertible_v<Answer, Answers<number_of_t<Answer>>>,
                "this type is no answer to the operation (see docs/operations.md)");
  return answer;
}
template <template <class> class Answers, class Answer>
std::optional<Answers<number_of_t<Answer>>> either(const std::optional<Answer>& answer) {
  if (!answer) return std::nullopt;
  return *answer;
}

/// The signatures, each named like its operation.
namespace signatures {}

/// The arguments and the answer of an operation, as the type of a function.
template <class Function>
struct Signature;
template <class TheAnswer, class... Arguments>
struct Signature<TheAnswer(Arguments...)> {
  using Question = std::tuple<Arguments...>;
  using Answer = TheAnswer;
};

template <class... S>
struct SignatureList {
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<S>(), ...);
  }
};

}  // namespace touchstone::catalogue
