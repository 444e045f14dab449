// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <type_traits>

#include "audit/engines/member.h"

/// The possible return values of an engine's member functions.
namespace touchstone::audit {

/// True if a type is an enumeration with an enumerator for "they do not meet".
template <class Word>
inline constexpr bool can_be_false = false;
template <Enumeration Word>
inline constexpr bool can_be_false<Word> = requires {
  Words<Word>::no;
};

/// True if true and false are also answers: if the answer is such an enumerator, or has one as a member.
template <class Answer>
constexpr bool has_plain_reading() {
  if constexpr (Composite<Answer>) {
    return []<class... Member>(Types<Member...>) { return (can_be_false<Member> || ...); }(member_types<Answer>());
  } else {
    return can_be_false<Answer>;
  }
}

/// The name of the member of an answer that has this enumeration as its type; nullptr if there is none.
template <class Answer, class Word>
const char* member_of_type() {
  const char* name = nullptr;
  if constexpr (Composite<Answer>) {
    std::size_t next = 0;
    const auto look = [&](bool found) {
      if (found) name = Answer::members.names[next];
      ++next;
    };
    [&]<class... Member>(Types<Member...>) { (look(std::is_same_v<Member, Word>), ...); }(member_types<Answer>());
  }
  return name;
}

template <class Answer, class Word>
constexpr bool has_member_of_type() {
  if constexpr (Composite<Answer>) {
    return
        []<class... Member>(Types<Member...>) { return (std::is_same_v<Member, Word> || ...); }(member_types<Answer>());
  }
  return false;
}

/// True if that enumerator alone is an answer: the rest of the answer is numbers, which may be omitted.
template <class Answer, class Word>
constexpr bool is_the_only_word() {
  return []<class... Member>(Types<Member...>) {
    return ((std::is_same_v<Member, Word> || may_be_left_out<rebound_t<Member, std::optional<double>>>)&&...);
  }(member_types<Answer>());
}

/// Result: the operation's answer over double or float, its enumerator alone, true or false if that is an answer, or a
/// std::optional of one of these, which is empty if the engine does not support the question.
template <class Answer, class Result>
MemberAnswer engine_answer(const Result& result) {
  using Kind = MemberAnswer::Kind;
  if constexpr (is_optional<Result>) {
    return result ? engine_answer<Answer>(*result) : MemberAnswer{};
  } else if constexpr (std::is_same_v<Result, bool>) {
    static_assert(has_plain_reading<Answer>(),
                  "true and false are no answer to this operation: return its enumeration");
    return {Kind::flag, packed(result)};
  } else if constexpr (std::is_same_v<Result, Answer> || std::is_same_v<Result, rebound_t<Answer, float>>) {
    return {Kind::whole, packed(result)};
  } else {
    static_assert(has_member_of_type<Answer, Result>(),
                  "this type is no answer to the operation (see geometry/answers.h)");
    static_assert(is_the_only_word<Answer, Result>(),
                  "this word alone is no answer to the operation: return the whole answer");
    return {Kind::word, packed(result), member_of_type<Answer, Result>()};
  }
}

}  // namespace touchstone::audit
