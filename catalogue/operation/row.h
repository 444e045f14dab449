// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <variant>

#include "catalogue/families/hard_case.h"
#include "catalogue/families/plane_draws.h"
#include "catalogue/numbers/ulps.h"
#include "catalogue/operation/own_cut.h"
#include "catalogue/operation/row_functions.h"
#include "catalogue/shape/encoded_value.h"
#include "oracle/truth.h"

/// A row of the catalogue is a struct named like its operation, in the file of that name. It holds
///   TOUCHSTONE_MODULES(op)                   the functions of the three modules; where a question's alternatives have
///                                            answers of different types: TOUCHSTONE_MODULES_EITHER(op), and before it
///                                            template <class R> using Answers = std::variant<Aabb2<R>, Aabb3<R>>
///   TOUCHSTONE_ARRAYS(op)                    where robust::batch has a function of that name: decisions over arrays
///   using stages = ::touchstone::robust::stages::op;    the stages of robust, if there are several
///   static void standard(const auto& add) {  other formulas of textbooks (reference/standard/), if there are any:
///     add("whose it is", [](const auto&... q) { return ...; });
///   }
///   using Question = std::tuple<...>;        the arguments; alternatives are a std::variant of tuples
///   static const Metadata& metadata();               names, pages, kind of judgement
///   static void hard_cases(HardCases<Question>& add) {        families that are hard on purpose:
///     add("shared_end", [](DrawStream& c) -> Question { return ...; });
///   }
///   struct decision { ... };                 decisions alone (below), or using decision = NoDecision;
///   static Hooks<op> hooks();                what else is particular; a misspelt name does not compile
/// Everything else - codec, families, judge, tests, fuzz target, vectors, report - follows from these.
#define TOUCHSTONE_ARRAYS(op)                                                                          \
  static auto batch(const auto&... operands)->decltype(::touchstone::robust::batch::op(operands...)) { \
    return ::touchstone::robust::batch::op(operands...);                                               \
  }
#define TOUCHSTONE_MODULES(op)                                                          \
  TOUCHSTONE_MEMBER_OF_ENGINES(op)                                                      \
  static auto reference(const auto&... q) { return ::touchstone::reference::op(q...); } \
  static auto robust(const auto&... q) { return ::touchstone::robust::op(q...); }       \
  static auto oracle(const auto&... q)->decltype(::touchstone::oracle::op(q...)) {      \
    return ::touchstone::oracle::op(q...);                                              \
  }                                                                                     \
  template <class E>                                                                    \
  static auto ask(E& engine, const auto&... q)->decltype(engine.op(q...)) {             \
    return engine.op(q...);                                                             \
  }
#define TOUCHSTONE_MODULES_EITHER(op)                                                                    \
  TOUCHSTONE_MEMBER_OF_ENGINES(op)                                                                       \
  static auto reference(const auto&... q) { return either<Answers>(::touchstone::reference::op(q...)); } \
  static auto robust(const auto&... q) { return either<Answers>(::touchstone::robust::op(q...)); }       \
  static auto oracle(const auto&... q)->decltype(either<Answers>(::touchstone::oracle::op(q...))) {      \
    return either<Answers>(::touchstone::oracle::op(q...));                                              \
  }                                                                                                      \
  template <class E>                                                                                     \
  static auto ask(E& engine, const auto&... q)->decltype(either<Answers>(engine.op(q...))) {             \
    return either<Answers>(engine.op(q...));                                                             \
  }
/// What tells that an engine has a member of the operation's name, whatever its arguments are: in a class derived from
/// the engine and from Namesake the name is ambiguous.
#define TOUCHSTONE_MEMBER_OF_ENGINES(op)                                                                  \
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

/// An answer to one alternative of a question, or the truth of it, as one of the answers to all of them.
template <template <class> class Answers, class Answer>
Answers<number_of_t<Answer>> either(const Answer& answer) {
  static_assert(std::is_convertible_v<Answer, Answers<number_of_t<Answer>>>,
                "this type is no answer to the operation (see docs/operations.md)");
  return answer;
}
template <template <class> class Answers, class Answer>
::touchstone::oracle::Truth<Answers<number_of_t<Answer>>> either(::touchstone::oracle::Truth<Answer> truth) {
  return {std::move(truth.answer), std::move(truth.margin), std::move(truth.certificate)};
}
template <template <class> class Answers, class Answer>
std::optional<Answers<number_of_t<Answer>>> either(const std::optional<Answer>& answer) {
  if (!answer) return std::nullopt;
  return *answer;
}

/// The rows, each named like its operation.
namespace rows {}

/// robust has no function for the decision alone. Where it has, the row's `decision` holds robust(Question) ->
/// enumerator, and, for exhaustive runs at full speed, oracle(Question) and oracle(the same over std::int64_t).
struct NoDecision {};

/// A function of the modules on a question.
template <class Call, class... Ts>
auto applied(const Call& call, const std::tuple<Ts...>& q) {
  return spread(call, q);
}
template <class Call, class... Ts>
auto applied(const Call& call, const std::variant<Ts...>& q) {
  return visited([&](const auto& alternative) { return applied(call, alternative); }, q);
}
template <class Row, class Question>
auto ask_reference(const Question& q) {
  return applied([](const auto&... value) { return Row::reference(value...); }, q);
}
template <class Row, class Question>
auto ask_robust(const Question& q) {
  return applied([]<class... Part>(const Part&... part) { return Row::robust(OwnCut<Part>(part)()...); }, q);
}
template <class Row, class Question>
auto ask_oracle(const Question& q) {
  return applied([](const auto&... value) { return Row::oracle(value...); }, q);
}

/// Whether the oracle also takes exact rationals, for numbers as they were typed.
template <class Row, class Asked>
inline constexpr bool oracle_takes = false;
template <class Row, class... Ts>
requires requires(const Ts&... q) { Row::oracle(q...); }
inline constexpr bool oracle_takes<Row, std::tuple<Ts...>> = true;
template <class Row, class... Ts>
inline constexpr bool oracle_takes<Row, std::variant<Ts...>> = (oracle_takes<Row, Ts> && ...);

template <class Row>
using answer_t = decltype(ask_robust<Row>(std::declval<const typename Row::Question&>()));
/// The answer as the oracle gives it.
template <class Row>
using truth_t = decltype(ask_oracle<Row>(std::declval<const typename Row::Question&>()).answer);

/// What is particular about a row, as functions; each may be left out.
template <class Row>
struct Hooks {
  using Question = typename Row::Question;
  /// The answer for open sets, if the truth is a touch.
  std::optional<truth_t<Row>> (*as_open_sets)(const truth_t<Row>& truth, const Question&) = nullptr;
  /// Where many answers are right: what is wrong with one; "" if it is right.
  std::string (*defect)(const Question&, const answer_t<Row>&) = nullptr;
  /// The same of an answer in exact numbers, which may be right as long as nothing rounds them; without it such an
  /// answer is right if it is the truth.
  std::string (*exact_defect)(const Question&, const rebound_t<answer_t<Row>, mpq_class>&) = nullptr;
  /// Of an answer with a defect, next to the truth in nearest doubles: how far it is from a right one.
  Excess (*excess)(const Question&, const answer_t<Row>& answer, const answer_t<Row>& truth) = nullptr;
  /// Where points of two shapes are as near as those of the truth: the truth with those that are nearest to an
  /// answer's.
  std::optional<truth_t<Row>> (*as_near)(const Question&, const truth_t<Row>& truth,
                                         const answer_t<Row>& answer) = nullptr;
  /// Repairs random numbers into a valid question (a ring that does not cross itself).
  void (*repair)(Question&) = nullptr;
  /// Times 2^k what is a length (default: every number).
  void (*scale)(Question&, int k) = nullptr;
  /// Of an answer that must cover: among how many elements each of its lists chooses (default: those of the question).
  std::vector<std::uint64_t> (*places)(const Question&) = nullptr;
  /// What is 0 of every right answer, exactly (momentum gained, energy gained).
  std::vector<mpq_class> (*residuals)(const Question&, const answer_t<Row>&) = nullptr;
  /// A degenerate question for the failure map (default: the first hard case at its simplest), and which of its numbers
  /// move (default: the last two).
  Question (*map_centre)() = nullptr;
  std::pair<std::size_t, std::size_t> (*map_axes)() = nullptr;
  /// Draws the question (default: every argument by its type), and of the truth, whose numbers are the nearest doubles,
  /// what its own type does not tell: the points that its indices mean.
  void (*draw)(Drawing&, const Question&, const answer_t<Row>& truth) = nullptr;
  /// Questions of exhaustive runs of that size: how many, and the one of an index (default: a grid of all numbers).
  std::uint64_t (*domain_count)(int size) = nullptr;
  Question (*domain_at)(int size, std::uint64_t index) = nullptr;
  /// For how many configurations of that grid it stands, where one is asked for all that symmetries make of it.
  std::uint64_t (*domain_weight)(int size, std::uint64_t index) = nullptr;
  /// Exact symmetries, asked of robust and oracle.
  Laws laws{};
};

class Operation;
/// The operation made from a row. Defined in the unit of the row's chapter, which CMake writes (cmake/modules.cmake).
template <class Row>
const Operation& operation_of_row();

}  // namespace touchstone::catalogue
