// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "audit/engines/engine_answer.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/row.h"

/// What the member functions of an engine look like: their signatures as types, for the compiler's messages, and as
/// text, for pages.
namespace touchstone::audit {

/// Function types: an operation's signature, one for each alternative of its questions.
template <class... Functions>
struct Signatures {};

/// A question as its alternatives, also where there is only one.
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

/// Where the alternatives have answers of different types, each has its own.
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
template <class Row>
using signatures_of = typename SignaturesOf<answer_t<Row>, alternatives_t<typename Row::Question>>::type;

/// As the compiler writes it, with more around it.
template <class T>
constexpr std::string_view written_by_compiler() {
  return __PRETTY_FUNCTION__;
}

/// "Segment2<double>", "std::vector<Point3<double>>": a type as users write it with `using namespace touchstone`.
template <class T>
std::string type_text() {
  if constexpr (std::is_same_v<T, Index>) {
    return "Index";
  } else if constexpr (is_vector<T>) {
    return "std::vector<" + type_text<typename T::value_type>() + ">";
  } else if constexpr (is_optional<T>) {
    return "std::optional<" + type_text<typename T::value_type>() + ">";
  } else {
    std::string text(written_by_compiler<T>());
    text.erase(0, text.find("T = ") + 4);
    text.erase(text.find_first_of(";]"));
    const std::string space = "touchstone::";
    for (std::size_t at; (at = text.find(space)) != std::string::npos;) text.erase(at, space.size());
    for (std::size_t at; (at = text.find("> >")) != std::string::npos;) text.erase(at + 1, 1);  // as g++ writes it
    return text;
  }
}

/// "(Segment2<double> a, Segment2<double> b)", of one alternative of an operation's questions.
template <class Arguments>
std::string arguments_text(const Operation& operation, std::size_t alternative) {
  std::string text;
  [&]<class... Ts>(const std::tuple<Ts...>*) {
    std::size_t at = 0;
    ((text += (at == 0 ? "" : ", ") + type_text<Ts>() + " " + operation.fields(alternative)[at], ++at), ...);
  }(static_cast<const Arguments*>(nullptr));
  return "(" + text + ")";
}

/// What an engine may return instead of the whole answer: "SegmentRelation", "bool".
template <class Answer>
std::vector<std::string> shorter_answers() {
  std::vector<std::string> found;
  if constexpr (Composite<Answer>) {
    for_each_member<Answer>([&](const auto& member) {
      using Part = std::remove_cvref_t<decltype(std::declval<Answer>().*member.pointer)>;
      if constexpr (Enumeration<Part>) {
        if (is_the_only_word<Answer, Part>()) found.push_back(type_text<Part>());
      }
    });
  }
  if (has_plain_reading<Answer>()) found.push_back("bool");
  return found;
}

/// A member function as it stands in an engine, and what else it may return.
struct Signature {
  std::string text;  ///< "SegmentSegment<double> segment_segment(Segment2<double> a, Segment2<double> b)"
  std::vector<std::string> instead;
};

/// One for each alternative of the operation's questions.
template <class Row>
std::vector<Signature> signature_texts() {
  const Operation& operation = *find_operation(Row::metadata().name);
  std::vector<Signature> found;
  const auto add = [&]<class Answer, class... Ts>(Answer (*)(Ts...)) {
    const std::string arguments = arguments_text<std::tuple<Ts...>>(operation, found.size());
    found.push_back({type_text<Answer>() + " " + operation.name() + arguments, shorter_answers<Answer>()});
  };
  [&]<class... Functions>(const Signatures<Functions...>*) {
    (add(static_cast<Functions*>(nullptr)), ...);
  }(static_cast<const signatures_of<Row>*>(nullptr));
  return found;
}

}  // namespace touchstone::audit
