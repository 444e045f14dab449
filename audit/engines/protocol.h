// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "audit/engines/engine.h"
#include "audit/engines/question_text.h"

/// The lines exchanged between the program and an engine, as promised by docs/engines.md.
namespace touchstone::audit {

/// "closed", "open", "unspecified"
std::string boundary_word(Declaration::Boundary boundary);

/// "conservative", "exact"
std::string pairs_word(Declaration::Pairs pairs);

/// "any", "named"
std::string nearest_word(Declaration::Nearest nearest);

struct Hello {
  Declaration declaration;
  std::set<std::string> operations;  ///< as the engine names them; unknown ones are never asked
  std::vector<std::string> remarks;  ///< on unknown fields and operations, with suggestions
};

/// The program's greeting: {"touchstone":1,"ops":[...]}, with a line end.
std::string greeting();
/// The reason why engines are not asked that method of an operation.
std::string why_never_asked(const Operation& method);

/// An engine's greeting. Fields other than "engine" and "ops" are optional: binary64, unspecified, tolerance 0,
/// conservative, any nearest points, no skew boxes.
/// Throws InvalidInput naming the field and the rule.
Hello read_hello(const std::string& line);
std::string written_hello(const Hello& hello);

void append_question_line(std::uint64_t id, const Metadata& metadata, const QuestionText& text,
                          const Question& question, std::string& lines);

/// The parts of a question's line if it has the form that append_question_line writes; otherwise empty.
struct QuestionLine {
  std::string_view id, operation, input;
};
std::optional<QuestionLine> split_question_line(std::string_view line);

/// True if a line that is not an answer was meant as one: it begins an object, and contains one of the fields of an
/// answer or nothing else. Any other such line does not concern a question.
bool meant_as_answer(std::string_view line);

/// The reply in an answer's object, whose id is not read; `failed` if there is none.
Reply read_reply(Json object);

/// One answer. Throws InvalidInput if the line is not an answer: not JSON, or without an id. If only the rest of it is
/// wrong, the reply is `failed`.
struct AnswerLine {
  std::uint64_t id = 0;
  Reply reply;
};
AnswerLine read_answer_line(const std::string& line);

}  // namespace touchstone::audit
