// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "robust/kernel/filters/strict_math.h"

/// The stages of an operation, and the dispatch between them.
namespace touchstone::robust {

/// The stage that decided, in the order in which stages are tried.
///
/// filter:   a few floating-point operations and a proved bound (robust/kernel/filters/filters.h); may not know.
/// enclosed: numbers to one and a half times the precision with a proved bound, and a rounding test
///           (robust/kernel/enclosed/enclosed.h); may not know.
/// lattice:  the input as integers below 2^61 on one common power of two, products in 128 bits; may not fit.
/// exact:    the input as integers of any size. Always knows.
///
/// stages::X, declared with the operation X and defined in its .cpp in the order in which stages are asked, is for
/// tests and other operations, and not part of the API:
///   X::filter, X::enclosed, X::lattice, X::exact
///                                     the stages that X has, of valid arguments. `exact` returns the answer, the
///                                     others Perhaps<Answer>, empty for "ask the next".
///   X::ask                            all in turn, and which of them decided; refuses arguments that are not valid.
///                                     Of several decisions the latest stage counts.
///   X::decision                       the same of the decision alone, where X also returns numbers.
///
/// A new stage is added here, in the list and in `asked`, and nowhere else: every operation declares the stages that it
/// has.
enum class Stage { filter, enclosed, lattice, exact };
inline constexpr Stage all_stages[] = {Stage::filter, Stage::enclosed, Stage::lattice, Stage::exact};

struct InPlace {};
inline constexpr InPlace in_place{};

/// The result of a stage: an answer, or nothing. Not std::optional, which g++ assembles in memory: that costs as much
/// as a determinant. An int tells whether there is an answer: g++ merges the paths to a bool, and then tests it.
template <class Answer>
class Perhaps {
 public:
  Perhaps() = default;
  /// From std::nullopt. <optional> would be longer than all else that an operation's header includes.
  template <class Nothing>
  requires(std::is_empty_v<Nothing>) Perhaps(const Nothing&) {}
  Perhaps(const Answer& answer) : known_(1), answer_(answer) {}
  /// An answer of several parts, constructed in place. Otherwise g++ constructs it in a temporary, part by part, and
  /// copies it by 16 bytes, for which the processor has to wait until the parts are in memory.
  template <class... Parts>
  Perhaps(InPlace, const Parts&... parts) : known_(1), answer_{parts...} {}
  explicit operator bool() const { return known_ != 0; }
  const Answer& operator*() const { return answer_; }

 private:
  int known_ = 0;
  Answer answer_{};
};

template <class Answer>
struct Decided {
  Answer answer;
  Stage stage;

  /// For operations of many decisions: sets `latest` to this stage if it is later.
  const Answer& noting(Stage& latest) const {
    if (latest < stage) latest = stage;
    return answer;
  }
};

/// The types of stages::X, of the type of the function X: static Partial enclosed, lattice; static Total exact;
template <class Function>
struct Signatures;
template <class Answer, class... Q>
struct Signatures<Answer(Q...)> {
  using Partial = Perhaps<Answer>(Q...);  ///< a stage that may not decide
  using Total = Answer(Q...);             ///< the stage that always decides
  using Staged = Decided<Answer>(Q...);   ///< all stages in turn: ask
};

/// A stage as the function of its name.
template <Stage stage>
using At = std::integral_constant<Stage, stage>;
template <class Stages>
auto asked(At<Stage::filter>, const auto&... q) -> decltype(Stages::filter(q...)) {
  return Stages::filter(q...);
}
template <class Stages>
auto asked(At<Stage::enclosed>, const auto&... q) -> decltype(Stages::enclosed(q...)) {
  return Stages::enclosed(q...);
}
template <class Stages>
auto asked(At<Stage::lattice>, const auto&... q) -> decltype(Stages::lattice(q...)) {
  return Stages::lattice(q...);
}
template <class Stages>
auto asked(At<Stage::exact>, const auto&... q) -> decltype(Stages::exact(q...)) {
  return Stages::exact(q...);
}

template <class Stages, auto step, auto... rest, class Tell, class... Q>
auto in_turn_telling(const Tell& tell, const Q&... q) {
  if constexpr (!std::is_same_v<std::remove_const_t<decltype(step)>, Stage>) {
    step(q...);
  } else if constexpr (sizeof...(rest) == 0) {
    return tell(asked<Stages>(At<step>(), q...), step);
  } else {
    if (const auto answer = asked<Stages>(At<step>(), q...)) return tell(*answer, step);
  }
  if constexpr (sizeof...(rest) > 0) return in_turn_telling<Stages, rest...>(tell, q...);
}

/// in_turn<Stages, Stage::filter, validate, Stage::lattice, Stage::exact>(arguments...): the first stage that can
/// decide does; the last one always can. An entry that is not a stage is a function that refuses invalid arguments: it
/// precedes the first stage that could answer them.
template <class Stages, auto... steps, class... Q>
auto in_turn(const Q&... q) {
  return in_turn_telling<Stages, steps...>(
      []<class Answer>(const Answer& answer, Stage stage) {
        return Decided<Answer>{answer, stage};
      },
      q...);
}

/// The same without the stage: saves one copy of an answer of several numbers, which is measurable.
template <class Stages, auto... steps, class... Q>
auto answer_in_turn(const Q&... q) {
  return in_turn_telling<Stages, steps...>([](const auto& answer, Stage) { return answer; }, q...);
}

/// Base of stages::X whose filter is inlined where X is called; past_filter, out of line, runs the other stages.
template <class X, class... Functions>
struct Filtered : Signatures<Functions>... {
  template <class... Q>
  static auto ask(const Q&... q) {
    using Found = decltype(X::past_filter(q...));
    if (const auto answer = X::filter(q...)) return Found{*answer, Stage::filter};
    return X::past_filter(q...);
  }
};

}  // namespace touchstone::robust
