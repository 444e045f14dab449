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

/// A row of the catalogue is a struct named like its operation, in the file of that name. It derives from the
/// operation's signature (catalogue/signatures/signature.h), which holds its name, question and answer, and adds
///   TOUCHSTONE_MODULES(op)                   the functions of the three modules; where a question's alternatives have
///                                            answers of different types: TOUCHSTONE_MODULES_EITHER(op)
///   TOUCHSTONE_ARRAYS(op)                    where robust::batch has a function of that name: decisions over arrays
///   TOUCHSTONE_PREPARED(op, Shape)           where robust takes shapes that are validated once (robust/prepared)
///   TOUCHSTONE_STAGED_MODULES(op)            instead, where robust has several stages: `stages` are those
///   static void standard(const auto& add) {  other formulas of textbooks (reference/standard/), if there are any:
///     add("whose it is", [](const auto&... q) { return ...; });
///   }
///   static constexpr Metadata metadata{...};          fields, pages, kind of judgement
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
#define TOUCHSTONE_PREPARED(op, Shape)                                               \
  static constexpr bool takes_prepared = true;                                       \
  static auto prepared(const auto&... q) {                                           \
    using ::touchstone::catalogue::prepared_as;                                      \
    return ::touchstone::robust::op(prepared_as<::touchstone::robust::Shape>(q)...); \
  }
#define TOUCHSTONE_MODULES(op)                                                          \
  static auto reference(const auto&... q) { return ::touchstone::reference::op(q...); } \
  static auto robust(const auto&... q) { return ::touchstone::robust::op(q...); }       \
  static auto oracle(const auto&... q)->decltype(::touchstone::oracle::op(q...)) {      \
    return ::touchstone::oracle::op(q...);                                              \
  }
#define TOUCHSTONE_STAGED_MODULES(op) \
  TOUCHSTONE_MODULES(op)              \
  using stages = ::touchstone::robust::stages::op;
#define TOUCHSTONE_MODULES_EITHER(op)                                                                    \
  static auto reference(const auto&... q) { return either<Answers>(::touchstone::reference::op(q...)); } \
  static auto robust(const auto&... q) { return either<Answers>(::touchstone::robust::op(q...)); }       \
  static auto oracle(const auto&... q)->decltype(either<Answers>(::touchstone::oracle::op(q...))) {      \
    return either<Answers>(::touchstone::oracle::op(q...));                                              \
  }

namespace touchstone::catalogue {

/// The truth of one alternative of a question as one of the truths of all of them.
template <template <class> class Answers, class Answer>
::touchstone::oracle::Truth<Answers<number_of_t<Answer>>> either(::touchstone::oracle::Truth<Answer> truth) {
  return {std::move(truth.answer), std::move(truth.margin), std::move(truth.certificate)};
}

/// The rows, each named like its operation.
namespace rows {}

/// robust has no function for the decision alone. If it has one, the row's `decision` holds robust(Question) ->
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

/// An argument of which Shape can be made as one; another stays as it is.
template <class Shape, class Part>
auto prepared_as(const Part& part) {
  if constexpr (std::is_constructible_v<Shape, const Part&>) return Shape(part);
  else return part;
}
template <class Row, class Question>
auto ask_prepared(const Question& q) {
  return applied([]<class... Part>(const Part&... part) { return Row::prepared(OwnCut<Part>(part)()...); }, q);
}

/// True if the oracle also accepts exact rationals, for numbers as they were typed.
template <class Row, class Asked>
inline constexpr bool oracle_takes = false;
template <class Row, class... Ts>
requires requires(const Ts&... q) { Row::oracle(q...); }
inline constexpr bool oracle_takes<Row, std::tuple<Ts...>> = true;
template <class Row, class... Ts>
inline constexpr bool oracle_takes<Row, std::variant<Ts...>> = (oracle_takes<Row, Ts> && ...);

template <class Row>
using answer_t = decltype(ask_robust<Row>(std::declval<const typename Row::Question&>()));
/// The type of the oracle's answer.
template <class Row>
using truth_t = decltype(ask_oracle<Row>(std::declval<const typename Row::Question&>()).answer);

/// The particular functions of a row; each is optional.
template <class Row>
struct Hooks {
  using Question = typename Row::Question;
  /// The answer for open sets, if the truth is a touch.
  std::optional<truth_t<Row>> (*as_open_sets)(const truth_t<Row>& truth, const Question&) = nullptr;
  /// If several answers are right: the defect of an answer; "" if it is right.
  std::string (*defect)(const Question&, const answer_t<Row>&) = nullptr;
  /// The same for an answer in exact numbers, which may be right only before it is rounded; without this hook such an
  /// answer is right if it is the truth.
  std::string (*exact_defect)(const Question&, const rebound_t<answer_t<Row>, mpq_class>&) = nullptr;
  /// For an answer with a defect, given with the truth in nearest doubles: its distance from a right one.
  Excess (*excess)(const Question&, const answer_t<Row>& answer, const answer_t<Row>& truth) = nullptr;
  /// If other points of two shapes are as near as those of the truth: the truth with those nearest to an answer's.
  std::optional<truth_t<Row>> (*as_near)(const Question&, const truth_t<Row>& truth,
                                         const answer_t<Row>& answer) = nullptr;
  /// Repairs random numbers into a valid question (a ring that does not cross itself).
  void (*repair)(Question&) = nullptr;
  /// Multiplies lengths by 2^k (default: every number).
  void (*scale)(Question&, int k) = nullptr;
  /// For an answer that must cover: the number of elements from which each of its lists chooses (default: those of the
  /// question).
  std::vector<std::uint64_t> (*places)(const Question&) = nullptr;
  /// The numbers that are exactly 0 for every right answer (momentum gained, energy gained).
  std::vector<mpq_class> (*residuals)(const Question&, const answer_t<Row>&) = nullptr;
  /// A degenerate question for the failure map (default: the first hard case at its simplest), and which of its numbers
  /// vary (default: the last two).
  Question (*map_centre)() = nullptr;
  std::pair<std::size_t, std::size_t> (*map_axes)() = nullptr;
  /// Draws the question (default: every argument by its type), and the part of the truth, given in nearest doubles,
  /// that its type alone does not tell: the points that its indices mean.
  void (*draw)(Drawing&, const Question&, const answer_t<Row>& truth) = nullptr;
  /// The questions of exhaustive runs of that size: their number, and the one of an index (default: a grid of all
  /// numbers).
  std::uint64_t (*domain_count)(int size) = nullptr;
  Question (*domain_at)(int size, std::uint64_t index) = nullptr;
  /// The number of configurations of that grid that it represents, if one question stands for all its symmetric images.
  std::uint64_t (*domain_weight)(int size, std::uint64_t index) = nullptr;
  /// Exact symmetries, tested for robust and oracle.
  Laws laws{};
};

class Operation;
/// The operation made from a row. Defined in the unit of the row's chapter, which CMake generates
/// (cmake/modules.cmake).
template <class Row>
const Operation& operation_of_row();

}  // namespace touchstone::catalogue
