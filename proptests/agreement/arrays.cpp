// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "catalogue/judge/environment.h"
#include "proptests/array_tables.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

// Where robust answers arrays, each row is answered as one question is, with every instruction set that this processor
// has.
namespace touchstone::proptests::arrays_tests {
namespace {

/// The first complaint about a table of questions.
template <class Complaint>
std::string first_of(const std::vector<Table>& tables, const Complaint& complaint) {
  for (const Table& table : tables) {
    std::string found = complaint(table);
    if (!found.empty()) return found;
  }
  return "";
}

std::size_t asked_of(const Operation& operation, std::uint64_t questions) {
  return static_cast<std::size_t>(
      affordable(operation, static_cast<std::uint64_t>(scaled(static_cast<int>(questions)))));
}

}  // namespace

EACH_OPERATION("over arrays it answers as one by one, and as the oracle") {
  if (operation.row().batch.decide == nullptr) return;
  const std::vector<Table> all = tables(operation, asked_of(operation, 20'000));
  demand(operation.name() + ": arrays as one by one", [&] {
    return first_of(all, [&](const Table& table) -> std::string {
      const std::vector<Word> expected = decisions(operation, table);
      std::string found = mismatch(operation, table, expected, expected.size(), all_of(table, 1), 0);
      if (found.empty()) found = mismatch(operation, table, expected, expected.size(), all_of(table, 3), 1);
      const std::size_t step = std::max<std::size_t>(1, expected.size() / 500);
      for (std::size_t i = 0; found.empty() && i < expected.size(); i += step) {
        if (operation.row().solve(table.questions[i]).answer.words.at(0) != expected[i])
          found = "the oracle decides otherwise: " + catalogue::one_line(operation.print(table.questions[i]));
      }
      return found;
    });
  });
}

EACH_OPERATION("over arrays of any length, alignment and stride it answers as one by one") {
  if (operation.row().batch.decide == nullptr) return;
  const auto complaint = [&](const Table& table) -> std::string {
    const std::vector<Word> expected = decisions(operation, table);
    // Where a list is shared it is validated in each call: each length with one alignment.
    const bool shares = table.columns.size() != table.questions[0].numbers.size();
    for (std::size_t count = 0; count <= std::min<std::size_t>(70, expected.size()); ++count) {
      for (std::size_t shift = 0; shift < 8; ++shift) {
        if (shares && shift != count % 8) continue;
        std::string found = mismatch(operation, table, expected, count, all_of(table, 1), shift);
        if (!found.empty()) return found;
        const auto stride = static_cast<std::ptrdiff_t>(shift % 4) + 2;
        found = mismatch(operation, table, expected, count, all_of(table, shift % 2 == 0 ? stride : -stride), shift);
        if (!found.empty()) return found;
      }
    }
    return "";
  };
  demand(operation.name() + ": arrays of any length", [&] { return first_of(tables(operation, 300), complaint); });
}

EACH_OPERATION("over arrays one operand that all rows share is as good as many") {
  if (operation.row().batch.decide == nullptr) return;
  const auto complaint = [&](const Table& table) -> std::string {
    // Each half of the columns in turn, and all of them.
    for (std::size_t part = 0; part < 3; ++part) {
      std::vector<std::ptrdiff_t> strides = all_of(table, 1);
      Table shared{{}, table.columns};
      for (std::size_t k = 0; k < strides.size(); ++k)
        if (part == 2 || (k < strides.size() / 2) == (part == 0)) strides[k] = 0;
      for (Question question : table.questions) {
        for (std::size_t k = 0; k < strides.size(); ++k)
          if (strides[k] == 0) question.numbers[table.columns[k]] = table.questions[0].numbers[table.columns[k]];
        if (refusal(operation, question).empty()) shared.questions.push_back(std::move(question));
      }
      const std::vector<Word> expected = decisions(operation, shared);
      for (const std::size_t count : {std::size_t{1}, std::size_t{63}, std::size_t{64}, expected.size()}) {
        if (count > expected.size()) continue;
        std::string found = mismatch(operation, shared, expected, count, strides, 3);
        if (!found.empty()) return found;
      }
    }
    return "";
  };
  demand(operation.name() + ": arrays that share", [&] { return first_of(tables(operation, 300), complaint); });
}

EACH_OPERATION("over arrays of numbers of any size it answers as one by one") {
  if (operation.row().batch.decide == nullptr) return;
  // By every power of two: a bound must not stay finite where something in the value overflows, nor hide underflow.
  const std::vector<Table> all = tables(operation, 300);
  demand(operation.name() + ": arrays of any size", [&]() -> std::string {
    int turn = 0;
    for (int exponent = -1074; exponent <= 1023; exponent += operation.metadata().cost) {
      const Table& table = all[static_cast<std::size_t>(turn++) % all.size()];
      Table scaled_table{{}, table.columns};
      for (Question question : table.questions) {
        for (double& number : question.numbers) number = std::ldexp(number, exponent);
        if (scaled_table.questions.size() < 70 && refusal(operation, question).empty())
          scaled_table.questions.push_back(std::move(question));
      }
      if (scaled_table.questions.empty()) continue;
      std::string found = mismatch(operation, scaled_table, decisions(operation, scaled_table),
                                   scaled_table.questions.size(), all_of(table, 1), 0);
      if (!found.empty()) return found;
    }
    return "";
  });
}

EACH_OPERATION("over arrays it answers alike in every floating-point environment") {
  if (operation.row().batch.decide == nullptr) return;
  const std::vector<Table> all = tables(operation, asked_of(operation, 1'000));
  demand(operation.name() + ": arrays in every environment", [&] {
    return first_of(all, [&](const Table& table) {
      const std::vector<Word> expected = decisions(operation, table);
      std::string found;
      for (std::size_t environment = 0; found.empty() && environment < catalogue::environment_count; ++environment)
        found = mismatch(operation, table, expected, expected.size(), all_of(table, 1), 0, environment);
      return found;
    });
  });
}

EACH_OPERATION("over arrays the first question that is refused is named") {
  if (operation.row().batch.decide == nullptr) return;
  const auto refused_otherwise = [&](const Table& table, const std::string& expected) -> std::string {
    for (const Instructions set : every_set) {
      std::vector<std::uint8_t> answers(table.questions.size());
      const Columns given(table, table.questions.size(), all_of(table, 1), 0);
      std::string said = "an answer";
      try {
        operation.row().batch.decide(table.questions[0], given.columns.data(), answers.size(), answers.data(), set);
      } catch (const InvalidInput& refused) {
        said = refused.what();
      }
      if (said != expected)
        return "instructions " + std::to_string(static_cast<int>(set)) + ": " + said + ", not " + expected;
    }
    return "";
  };
  Table table = tables(operation, 300)[0];
  table.questions.resize(std::min<std::size_t>(table.questions.size(), 200));
  demand(operation.name() + ": arrays with a number that is not finite", [&]() -> std::string {
    for (const std::size_t place : {std::size_t{0}, std::size_t{17}, std::size_t{69}}) {
      const Question kept = table.questions.at(place);
      for (const std::size_t k : table.columns) {
        for (const double bad : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
          table.questions[place].numbers[k] = bad;
          const std::string rule = refusal(operation, table.questions[place]);
          const std::string found = refused_otherwise(table, "questions[" + std::to_string(place) + "]." + rule);
          if (!found.empty()) return found;
        }
        table.questions[place] = kept;
      }
    }
    return "";
  });
  // What the families break on purpose: a radius below 0, a normal of length 0, a polygon that is not convex.
  demand(operation.name() + ": arrays with a rule that is broken", [&]() -> std::string {
    for (const Question& bad : drawn(operation, 200, false)) {
      const bool shares = operation.row().batch.columns(bad).size() != bad.numbers.size();
      Table with{{}, operation.row().batch.columns(bad)};
      std::string expected = "questions[40]." + refusal(operation, bad);
      if (shares) {  // what all rows share is refused before any row
        Question of_row = table.questions[0], of_shape = bad;
        take_columns(operation, of_row, bad), take_columns(operation, of_shape, table.questions[0]);
        const std::string row = refusal(operation, of_row), shape = refusal(operation, of_shape);
        expected = shape.empty() ? "questions[0]." + row : shape;
        with.questions.assign(70, bad);
      } else {
        if (bad.words != table.questions[0].words) continue;
        with = table;
        with.questions[40] = bad;
      }
      const std::string found = refused_otherwise(with, expected);
      if (!found.empty()) return found;
    }
    return "";
  });
}

}  // namespace touchstone::proptests::arrays_tests
