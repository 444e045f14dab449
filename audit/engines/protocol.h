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

/// The lines between the program and an engine, as docs/engines.md promises them.
namespace touchstone::audit {

/// "closed", "open", "unspecified"
std::string boundary_word(Declaration::Boundary boundary);

/// "conservative", "exact"
std::string pairs_word(Declaration::Pairs pairs);

/// "any", "named"
std::string nearest_word(Declaration::Nearest nearest);

struct Hello {
  Declaration declaration;
  std::set<std::string>
      operations;  ///< as the engine names them; those that the catalogue does not know are never asked
  std::vector<std::string> remarks;  ///< on fields and operations that are not known, with what may have been meant
};

/// What the program says: {"touchstone":1,"ops":[...]}, with the line's end.
std::string greeting();
/// Why engines are not asked that method of an operation.
std::string why_never_asked(const Operation& method);

/// What an engine says. Fields other than "engine" and "ops" may be left out: binary64, unspecified, tolerance 0,
/// conservative, any nearest points, no skew boxes.
/// Throws InvalidInput naming the field and the rule.
Hello read_hello(const std::string& line);
std::string written_hello(const Hello& hello);

void append_question_line(std::uint64_t id, const Metadata& metadata, const QuestionText& text,
                          const Question& question, std::string& lines);

/// The parts of a question's line where it is as append_question_line writes it; nothing otherwise.
struct QuestionLine {
  std::string_view id, operation, input;
};
std::optional<QuestionLine> split_question_line(std::string_view line);

/// Whether a line that is no answer was meant as one: it begins an object, and holds one of the fields of an answer or
/// nothing else. Any other such line is not about a question.
bool meant_as_answer(std::string_view line);

/// One answer. Throws InvalidInput where the line is none: not JSON, or without an id. Where only the rest of it is
/// wrong, the reply is `failed`.
struct AnswerLine {
  std::uint64_t id = 0;
  Reply reply;
};
AnswerLine read_answer_line(const std::string& line);

}  // namespace touchstone::audit
