// SPDX-License-Identifier: Apache-2.0
#include "proptests/array_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "catalogue/judge/environment.h"

namespace touchstone::proptests::arrays_tests {
namespace {

using catalogue::DrawStream;

/// What robust decides of one question.
Word decision(const Operation& operation, const Question& question, std::size_t environment = 0) {
  const auto& row = operation.row();
  return row.decide != nullptr ? row.decide(question, environment) : row.robust(question, environment).words.at(0);
}

}  // namespace

std::string refusal(const Operation& operation, const Question& question) {
  try {
    decision(operation, question);
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "";
}

std::vector<Question> drawn(const Operation& operation, std::size_t count, bool valid) {
  std::vector<Question> questions;
  for (std::uint64_t i = 0; questions.size() < count && i < 40 * count; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "arrays", i));
    Question question = operation.draw(draws, i % operation.families().size());
    if (refusal(operation, question).empty() == valid) questions.push_back(std::move(question));
  }
  return questions;
}

void take_columns(const Operation& operation, Question& question, const Question& other) {
  const std::vector<std::size_t> to = operation.row().batch.columns(question),
                                 from = operation.row().batch.columns(other);
  for (std::size_t k = 0; k < from.size(); ++k) question.numbers[to[k]] = other.numbers[from[k]];
}

std::vector<Table> tables(const Operation& operation, std::size_t count) {
  constexpr std::size_t rows_of_a_list = 75;
  std::vector<Table> made;
  const auto columns_of = operation.row().batch.columns;
  const std::vector<Question> first = drawn(operation, 1, true);
  if (columns_of(first[0]).size() == first[0].numbers.size()) {
    std::map<std::vector<Word>, Table> by_words;
    for (Question& question : drawn(operation, count, true)) {
      Table& table = by_words[question.words];
      if (table.questions.empty()) table.columns = columns_of(question);
      table.questions.push_back(std::move(question));
    }
    for (auto& [words, table] : by_words) made.push_back(std::move(table));
    return made;
  }
  const std::vector<Question> questions = drawn(operation, std::max<std::size_t>(count / rows_of_a_list, 8), true);
  for (std::size_t n = 0; n < questions.size(); ++n) {
    Table table{{}, columns_of(questions[n])};
    for (std::size_t i = 0; i < rows_of_a_list; ++i) {
      Question question = questions[n];
      const Question& other = questions[(n + i) % questions.size()];
      const std::vector<std::size_t> others = columns_of(other);
      take_columns(operation, question, other);
      // Every second one of the shape's own numbers: points on vertices, and between them.
      const std::size_t at = i % question.numbers.size();
      if (i % 2 == 1 && at + others.size() <= question.numbers.size())
        for (std::size_t k = 0; k < others.size(); ++k)
          question.numbers[table.columns[k]] = questions[n].numbers[at + k];
      table.questions.push_back(refusal(operation, question).empty() ? std::move(question) : questions[n]);
    }
    made.push_back(std::move(table));
  }
  return made;
}

Columns::Columns(const Table& table, std::size_t count, const std::vector<std::ptrdiff_t>& strides, std::size_t shift)
    : numbers(table.columns.size()) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const std::ptrdiff_t stride = strides[k], last = count == 0 ? 0 : static_cast<std::ptrdiff_t>(count - 1);
    const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(shift) + (stride < 0 ? -stride * last : 0);
    numbers[k].assign(shift + static_cast<std::size_t>(std::abs(stride) * last) + 1,
                      std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = count; i-- > 0;)
      numbers[k][static_cast<std::size_t>(start + stride * static_cast<std::ptrdiff_t>(i))] =
          table.questions[i].numbers[table.columns[k]];
    columns.emplace_back(numbers[k].data() + start, stride);
  }
}

std::vector<Word> decisions(const Operation& operation, const Table& table) {
  std::vector<Word> answers;
  for (const Question& question : table.questions) answers.push_back(decision(operation, question));
  return answers;
}

std::string mismatch(const Operation& operation, const Table& table, const std::vector<Word>& expected,
                     std::size_t count, const std::vector<std::ptrdiff_t>& strides, std::size_t shift,
                     std::size_t environment) {
  const Columns given(table, count, strides, shift);
  for (const Instructions set : every_set) {
    std::vector<std::uint8_t> answers(count + 1, 255);
    {
      const catalogue::Environment environment_set(environment);
      operation.row().batch.decide(table.questions[0], given.columns.data(), count, answers.data(), set);
    }
    const auto of_set = [set] { return "instructions " + std::to_string(static_cast<int>(set)) + ", "; };
    if (answers[count] != 255) return of_set() + "written behind row " + std::to_string(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (answers[i] == expected[i]) continue;
      return of_set() + "row " + std::to_string(i) + " of " + std::to_string(count) + ", " +
             std::to_string(answers[i]) + " instead of " + std::to_string(expected[i]) + ": " +
             catalogue::one_line(operation.print(table.questions[i]));
    }
  }
  return "";
}

std::vector<std::ptrdiff_t> all_of(const Table& table, std::ptrdiff_t stride) {
  return std::vector<std::ptrdiff_t>(table.columns.size(), stride);
}

}  // namespace touchstone::proptests::arrays_tests
