// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <type_traits>

#include "audit/uses.h"
#include "catalogue/codec/shape_json.h"
#include "catalogue/operation/row.h"

/// What a member function of an engine may return, and how it reads in JSON.
namespace touchstone::audit {

/// Whether a type is an enumeration with a word that says "they do not meet".
template <class Word>
inline constexpr bool can_be_false = false;
template <Enumeration Word>
inline constexpr bool can_be_false<Word> = requires {
  Words<Word>::no;
};

/// Whether true and false are answers too: where an answer is such a word, or has one as a member.
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

/// Whether that word alone is an answer: whatever else the answer holds are numbers, which may be left out.
template <class Answer, class Word>
constexpr bool is_the_only_word() {
  return []<class... Member>(Types<Member...>) {
    return ((std::is_same_v<Member, Word> || may_be_left_out<rebound_t<Member, std::optional<double>>>)&&...);
  }(member_types<Answer>());
}

/// Empty: the engine does not support this question. Result: the operation's answer over double or float, its word
/// alone, true or false where that is an answer, or a std::optional of one of these.
template <class Row, class Result>
std::optional<Json> engine_answer(const Result& result) {
  using Answer = answer_t<Row>;
  const auto named = [](const char* name, Json value) {
    if (name == nullptr || name[0] == 0) return value;
    Json object = Json::object();
    object[name] = std::move(value);
    return object;
  };
  if constexpr (is_optional<Result>) {
    if (!result) return std::nullopt;
    return engine_answer<Row>(*result);
  } else if constexpr (std::is_same_v<Result, bool>) {
    static_assert(has_plain_reading<Answer>(),
                  "true and false are no answer to this operation: return its enumeration");
    return Json(result);
  } else if constexpr (std::is_same_v<Result, rebound_t<Answer, double>>) {
    return named(Row::metadata().answer, to_json(result));
  } else if constexpr (std::is_same_v<Result, rebound_t<Answer, float>>) {
    return named(Row::metadata().answer,
                 to_json(converted<double>(result, [](float number) { return double{number}; })));
  } else {
    static_assert(has_member_of_type<Answer, Result>(),
                  "this type is no answer to the operation (see geometry/answers.h)");
    static_assert(is_the_only_word<Answer, Result>(),
                  "this word alone is no answer to the operation: return the whole answer");
    return named(member_of_type<Answer, Result>(), to_json(result));
  }
}

}  // namespace touchstone::audit
