// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "audit/engines/engine_answer.h"
#include "audit/engines/serve.h"
#include "audit/engines/signature.h"
#include "catalogue/catalogue.h"
#include "catalogue/operation/operation.h"

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

template <class Engine, class Row, class... Arguments>
concept AnswersTo = requires(Engine& engine, const Arguments&... arguments) {
  Row::ask(engine, arguments...);
};

/// True if the engine has a row's operation on shapes over Real.
template <class Engine, class Row, class Tuple>
inline constexpr bool answers_row = false;
template <class Engine, class Row, class... Ts>
inline constexpr bool answers_row<Engine, Row, std::tuple<Ts...>> = AnswersTo<Engine, Row, Ts...>;
template <class Engine, class Row, class... Ts>
inline constexpr bool answers_row<Engine, Row, std::variant<Ts...>> = (answers_row<Engine, Row, Ts> || ...);
template <class Engine, class Row, class Real>
inline constexpr bool has_operation = answers_row<Engine, Row, rebound_t<typename Row::Question, Real>>;

/// A struct, so that the compiler reports the error once.
template <class Engine>
struct NotFinal {
  static_assert(!std::is_final_v<Engine>, "an engine's struct is not final: else its members cannot be told by name");
};
template <class Engine, class Row>
struct EngineAndNamesake : Engine, Row::Namesake {};
/// True if the engine has a member of the operation's name, of any kind.
template <class Engine, class Row>
constexpr bool names_operation() {
  if constexpr (std::is_final_v<Engine>) return sizeof(NotFinal<Engine>) == 0;
  else return Row::template is_ambiguous<EngineAndNamesake<Engine, Row>>;
}

/// Does not compile if the engine has a member of the operation's name that does not take its arguments.
template <class Row, class Engine>
constexpr void require_signature() {
  constexpr bool has = has_operation<Engine, Row, double> || has_operation<Engine, Row, float>;
  constexpr bool has_signature = has || !names_operation<Engine, Row>();
  [&]<class... Expected>(const Signatures<Expected...>*) {
    Row::template require_signature<has_signature, Expected...>();
  }(static_cast<const signatures_of<Row>*>(nullptr));
}

/// The alternatives of a question for which the engine has an overload, and the arguments of those for which it has
/// none: "(Sphere3<double> a, ...)".
struct Alternatives {
  std::set<std::size_t> answered{};
  std::vector<std::string> left_out{};
};
template <class Row, class Engine>
Alternatives alternatives_of() {
  Alternatives found;
  [&]<class... Ts>(const std::variant<Ts...>*) {
    std::size_t at = 0;
    const auto look = [&]<class Alternative>(const Alternative*) {
      constexpr bool answers =
          answers_row<Engine, Row, Alternative> || answers_row<Engine, Row, rebound_t<Alternative, float>>;
      if (answers) found.answered.insert(at);
      else found.left_out.push_back(arguments_text(*find_operation(Row::metadata().name), at));
      ++at;
    };
    (look(static_cast<const Ts*>(nullptr)), ...);
  }(static_cast<const alternatives_t<typename Row::Question>*>(nullptr));
  return found;
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
template <class Engine, class Row>
using handed_number = std::conditional_t<has_operation<Engine, Row, number_of<Engine>>, number_of<Engine>,
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
template <class Row, class Engine, class... Ts>
std::optional<Json> said_to(Engine& engine, const std::tuple<Ts...>& asked) {
  if constexpr (AnswersTo<Engine, Row, Ts...>) {
    return spread([&](const auto&... value) { return engine_answer<Row>(Row::ask(engine, value...)); }, asked);
  }
  return std::nullopt;
}
template <class Row, class Engine, class... Ts>
std::optional<Json> said_to(Engine& engine, const std::variant<Ts...>& asked) {
  return visited([&](const auto& alternative) { return said_to<Row>(engine, alternative); }, asked);
}

/// The engine's answer to one question of a row; empty: unsupported.
template <class Row, class Engine>
std::optional<Json> ask_engine(Engine& engine, const Question& question) {
  require_signature<Row, Engine>();
  using Real = handed_number<Engine, Row>;
  const auto asked = unpacked<rebound_t<typename Row::Question, Real>>(
      question, [](double number) { return static_cast<Real>(number); });
  return said_to<Row>(engine, asked);
}

template <class Engine, class List>
inline constexpr bool has_any_of = false;
template <class Engine, class... AllRows>
inline constexpr bool has_any_of<Engine, RowList<AllRows...>> =
    ((has_operation<Engine, AllRows, double> || has_operation<Engine, AllRows, float>) || ...);
template <class Engine, class List>
inline constexpr bool names_any_of = false;
template <class Engine, class... AllRows>
requires(!std::is_final_v<Engine>) inline constexpr bool names_any_of<Engine, RowList<AllRows...>> =
    (names_operation<Engine, AllRows>() || ...);

template <class Engine>
Served served(Engine& engine) {
  // If there is one of the name, require_signature reports what is wrong with it.
  static_assert(has_any_of<Engine, Rows> || names_any_of<Engine, Rows>,
                "the engine has no member function of the name and arguments of an operation (touchstone ops)");
  Served all;
  all.hello.declaration = declaration_of<Engine>();
  for_each_row([&]<class Row>() {
    require_signature<Row, Engine>();
    if constexpr (has_operation<Engine, Row, double> || has_operation<Engine, Row, float>) {
      const Operation& operation = *find_operation(Row::metadata().name);
      if (operation.metadata().is_implementation()) return;  // engines are asked only the operation itself
      all.hello.operations.insert(operation.name());
      const Alternatives alternatives = alternatives_of<Row, Engine>();
      if (!alternatives.left_out.empty()) all.hello.declaration.alternatives[operation.name()] = alternatives.answered;
      for (const std::string& arguments : alternatives.left_out) all.left_out.push_back(operation.name() + arguments);
      all.operations.emplace(operation.name(),
                             ServedOperation{operation, QuestionText(operation), [&engine](const Question& question) {
                                               return ask_engine<Row>(engine, question);
                                             }});
    }
  });
  return all;
}

}  // namespace audit
}  // namespace touchstone
