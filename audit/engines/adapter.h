// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/engines/engine_answer.h"
#include "audit/engines/function_types.h"
#include "catalogue/signatures/all.h"

/// Audits a C++ implementation. An engine is a struct:
///
///   struct MyEngine {
///     static constexpr const char* name = "my library 1.0";
///     static constexpr auto boundary = touchstone::Boundary::closed;   // or open; left out: unspecified
///     using number = double;                                           // or float; left out: double
///     static constexpr double tolerance = 0;                           // left out: 0
///     static constexpr auto pairs = touchstone::Pairs::exact;          // left out: conservative
///     static constexpr auto nearest = touchstone::Nearest::named;      // left out: any
///     static constexpr bool skew_boxes = true;                         // left out: boxes at right angles alone
///     static constexpr bool polygons = true;                           // left out: meshes of triangles alone
///     bool segment_segment(const touchstone::Segment2d& a, const touchstone::Segment2d& b) { ... }
///   };
///   TOUCHSTONE_ENGINE_MAIN(MyEngine)
///
/// with one member function for each operation that it has, with the operation's name and arguments (geometry/*.h).
/// docs/operations.md lists all signatures, docs/engines.md the possible return types. A member that has an operation's
/// name and does not take its arguments does not compile.
namespace touchstone {

using Boundary = catalogue::Declaration::Boundary;
using Pairs = catalogue::Declaration::Pairs;
using Nearest = catalogue::Declaration::Nearest;

namespace audit {

template <class Engine, class Operation, class... Arguments>
concept AnswersTo = requires(Engine& engine, const Arguments&... arguments) {
  Operation::ask(engine, arguments...);
};

/// True if the engine has an operation on shapes over Real.
template <class Engine, class Operation, class Tuple>
inline constexpr bool answers = false;
template <class Engine, class Operation, class... Ts>
inline constexpr bool answers<Engine, Operation, std::tuple<Ts...>> = AnswersTo<Engine, Operation, Ts...>;
template <class Engine, class Operation, class... Ts>
inline constexpr bool answers<Engine, Operation, std::variant<Ts...>> = (answers<Engine, Operation, Ts> || ...);
template <class Engine, class Operation, class Real>
inline constexpr bool has_operation = answers<Engine, Operation, rebound_t<typename Operation::Question, Real>>;

/// A struct, so that the compiler reports the error once.
template <class Engine>
struct NotFinal {
  static_assert(!std::is_final_v<Engine>, "an engine's struct is not final: else its members cannot be told by name");
};
template <class Engine, class Operation>
struct EngineAndNamesake : Engine, Operation::Namesake {};
/// True if the engine has a member of the operation's name, of any kind.
template <class Engine, class Operation>
constexpr bool names_operation() {
  if constexpr (std::is_final_v<Engine>) return sizeof(NotFinal<Engine>) == 0;
  else return Operation::template is_ambiguous<EngineAndNamesake<Engine, Operation>>;
}

/// Does not compile if the engine has a member of the operation's name that does not take its arguments.
template <class Operation, class Engine>
constexpr void require_signature() {
  constexpr bool has = has_operation<Engine, Operation, double> || has_operation<Engine, Operation, float>;
  constexpr bool has_signature = has || !names_operation<Engine, Operation>();
  [&]<class... Expected>(const Signatures<Expected...>*) {
    Operation::template require_signature<has_signature, Expected...>();
  }(static_cast<const signatures_of<Operation>*>(nullptr));
}

/// Sorts the alternatives of a question by whether the engine has an overload for them.
template <class Operation, class Engine>
void sort_alternatives(Member& member) {
  [&]<class... Ts>(const std::variant<Ts...>*) {
    std::size_t at = 0;
    const auto sort = [&]<class Alternative>(const Alternative*) {
      constexpr bool has =
          answers<Engine, Operation, Alternative> || answers<Engine, Operation, rebound_t<Alternative, float>>;
      (has ? member.answered : member.left_out).push_back(at++);
    };
    (sort(static_cast<const Ts*>(nullptr)), ...);
  }(static_cast<const alternatives_t<typename Operation::Question>*>(nullptr));
}

template <class Engine>
struct NumberOf {
  using type = double;
};
template <class Engine>
requires requires { typename Engine::number; }
struct NumberOf<Engine> {
  using type = typename Engine::number;
};
template <class Engine>
using number_of = typename NumberOf<Engine>::type;

/// The number type of the shapes that the engine gets for an operation: its own if it takes that.
template <class Engine, class Operation>
using handed_number = std::conditional_t<has_operation<Engine, Operation, number_of<Engine>>, number_of<Engine>,
                                         std::conditional_t<std::is_same_v<number_of<Engine>, double>, float, double>>;

template <class Engine>
Declaration declaration_of() {
  static_assert(std::is_same_v<number_of<Engine>, double> || std::is_same_v<number_of<Engine>, float>,
                "an engine's number is float or double");
  Declaration declaration;
  declaration.engine = Engine::name;
  declaration.binary32 = std::is_same_v<number_of<Engine>, float>;
  if constexpr (requires { Engine::boundary; }) declaration.boundary = Engine::boundary;
  if constexpr (requires { Engine::tolerance; }) declaration.tolerance = Engine::tolerance;
  if constexpr (requires { Engine::pairs; }) declaration.pairs = Engine::pairs;
  if constexpr (requires { Engine::nearest; }) declaration.nearest = Engine::nearest;
  if constexpr (requires { Engine::skew_boxes; }) declaration.skew_boxes = Engine::skew_boxes;
  if constexpr (requires { Engine::polygons; }) declaration.polygons = Engine::polygons;
  return declaration;
}

/// An alternative of a question for which the engine has no overload is not supported.
template <class Operation, class Engine, class... Ts>
MemberAnswer asked_of(Engine& engine, const std::tuple<Ts...>& asked) {
  if constexpr (AnswersTo<Engine, Operation, Ts...>) {
    return spread(
        [&](const auto&... value) {
          return engine_answer<typename Operation::Answer>(Operation::ask(engine, value...));
        },
        asked);
  }
  return {};
}
template <class Operation, class Engine, class... Ts>
MemberAnswer asked_of(Engine& engine, const std::variant<Ts...>& asked) {
  return visited([&](const auto& alternative) { return asked_of<Operation>(engine, alternative); }, asked);
}

/// The engine's answer to one question of an operation.
template <class Operation, class Engine>
MemberAnswer ask_member(void* engine, const Question& question) {
  using Real = handed_number<Engine, Operation>;
  const auto asked = unpacked<rebound_t<typename Operation::Question, Real>>(
      question, [](double number) { return static_cast<Real>(number); });
  return asked_of<Operation>(*static_cast<Engine*>(engine), asked);
}

template <class Engine, class List>
inline constexpr bool has_any_of = false;
template <class Engine, class... All>
inline constexpr bool has_any_of<Engine, SignatureList<All...>> =
    ((has_operation<Engine, All, double> || has_operation<Engine, All, float>) || ...);
template <class Engine, class List>
inline constexpr bool names_any_of = false;
template <class Engine, class... All>
requires(!std::is_final_v<Engine>) inline constexpr bool names_any_of<Engine, SignatureList<All...>> =
    (names_operation<Engine, All>() || ...);

/// The engine with its types erased. The engine has to outlive the result.
template <class Engine>
EngineMembers members_of(Engine& engine) {
  // If there is one of the name, require_signature reports what is wrong with it.
  using catalogue::AllSignatures;
  static_assert(has_any_of<Engine, AllSignatures> || names_any_of<Engine, AllSignatures>,
                "the engine has no member function of the name and arguments of an operation (touchstone ops)");
  EngineMembers all{declaration_of<Engine>(), &engine};
  AllSignatures::for_each([&]<class Operation>() {
    require_signature<Operation, Engine>();
    if constexpr (has_operation<Engine, Operation, double> || has_operation<Engine, Operation, float>) {
      all.members.push_back({Operation::name, ask_member<Operation, Engine>});
      sort_alternatives<Operation, Engine>(all.members.back());
    }
  });
  return all;
}

}  // namespace audit
}  // namespace touchstone
