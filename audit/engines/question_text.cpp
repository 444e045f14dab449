// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/question_text.h"

#include <charconv>
#include <cmath>

namespace touchstone::audit {
namespace {

/// Represents every number while the pattern is built; no field has it in its name.
constexpr double placeholder = 0x1.8p+200;

void append_number(double number, std::string& text) {
  char digits[40];
  char* const end = digits + sizeof digits;
  if (number == std::trunc(number) && std::fabs(number) < 0x1p53) {
    if (number == 0 && std::signbit(number)) {
      text += "-0.0";
      return;
    }
    text.append(digits, std::to_chars(digits, end, static_cast<std::int64_t>(number)).ptr);
  } else {
    text.append(digits, std::to_chars(digits, end, number).ptr);
  }
}

}  // namespace

QuestionText::QuestionText(const Operation& operation) : operation_(operation) {
  Question marked = operation.zeros();
  if (!marked.words.empty()) return;  // lists, enumerators: only the codec reads them
  for (double& number : marked.numbers) number = placeholder;
  const std::string pattern = one_line(operation.print(marked));
  const std::string mark = decimal(placeholder);
  std::size_t begin = 0;
  for (std::size_t end; (end = pattern.find(mark, begin)) != std::string::npos; begin = end + mark.size()) {
    around_.push_back(pattern.substr(begin, end - begin));
  }
  around_.push_back(pattern.substr(begin));
  if (around_.size() != marked.numbers.size() + 1) around_.clear();
}

void QuestionText::write(const Question& question, std::string& text) const {
  if (around_.empty()) {
    text += one_line(operation_.print(question));
    return;
  }
  for (std::size_t i = 0; i < question.numbers.size(); ++i) {
    text += around_[i];
    append_number(question.numbers[i], text);
  }
  text += around_.back();
}

bool QuestionText::read(std::string_view text, Question& question) const {
  question.clear();
  for (std::size_t i = 0; i < around_.size(); ++i) {
    if (text.substr(0, around_[i].size()) != around_[i]) return false;
    text.remove_prefix(around_[i].size());
    if (i + 1 == around_.size()) return text.empty();
    double number = 0;
    const char first = text.empty() ? ' ' : text[text[0] == '-' && text.size() > 1 ? 1 : 0];
    if (first < '0' || first > '9') return false;  // from_chars would accept "inf"
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    question.numbers.push_back(number);
  }
  return false;
}

}  // namespace touchstone::audit
