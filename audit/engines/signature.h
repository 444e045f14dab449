// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/engines/engine_answer.h"
#include "catalogue/operation/operation.h"
#include "catalogue/operation/row.h"

/// The signatures of an engine's member functions: as types, for the compiler's messages, and as text, for pages.
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
template <class Row>
using signatures_of = typename SignaturesOf<answer_t<Row>, alternatives_t<typename Row::Question>>::type;

/// A member function as written in an engine, and its other possible return types.
struct Signature {
  std::string text;  ///< "SegmentSegment<double> segment_segment(Segment2<double> a, Segment2<double> b)"
  std::vector<std::string> instead;
};

/// One for each alternative of the operation's questions.
std::vector<Signature> signatures(const Operation& operation);

/// The arguments of one alternative: "(Segment2<double> a, Segment2<double> b)".
std::string arguments_text(const Operation& operation, std::size_t alternative);

}  // namespace touchstone::audit
