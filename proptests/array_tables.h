// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "catalogue/operation/operation.h"
#include "robust/batch/isa/columns.h"

/// Tables of questions for the tests of arrays.
namespace touchstone::proptests::arrays_tests {

using catalogue::Operation;
using catalogue::Question;
using catalogue::Word;
using robust::batch::Column;
using robust::batch::Instructions;

inline constexpr Instructions every_set[] = {Instructions::portable, Instructions::avx2, Instructions::avx512};

/// Who is wrong; empty where it is nobody.
std::string refusal(const Operation& operation, const Question& question);

/// Questions that arrays can ask in one call: they differ in the columns' numbers alone.
struct Table {
  std::vector<Question> questions;
  std::vector<std::size_t> columns;
};

/// As many questions of all families in turn, those that are refused too or not.
std::vector<Question> drawn(const Operation& operation, std::size_t count, bool valid);

/// Gives a question the numbers that another has in its columns.
void take_columns(const Operation& operation, Question& question, const Question& other);

/// Tables of questions: where every argument has columns, one for each alternative; else one for each question, whose
/// rows take their numbers from that one and from others in turn.
std::vector<Table> tables(const Operation& operation, std::size_t count);

/// The first questions of a table as columns, each number `stride` after the one before (0: all are that of the first),
/// the first `shift` after an aligned address.
struct Columns {
  std::vector<std::vector<double>> numbers;
  std::vector<Column> columns;
  Columns(const Table& table, std::size_t count, const std::vector<std::ptrdiff_t>& strides, std::size_t shift);
};

/// What robust decides of each question of a table.
std::vector<Word> decisions(const Operation& operation, const Table& table);

/// What arrays answer otherwise than expected; empty where it is nothing.
std::string mismatch(const Operation& operation, const Table& table, const std::vector<Word>& expected,
                     std::size_t count, const std::vector<std::ptrdiff_t>& strides, std::size_t shift,
                     std::size_t environment = 0);

/// That stride for every column.
std::vector<std::ptrdiff_t> all_of(const Table& table, std::ptrdiff_t stride);

}  // namespace touchstone::proptests::arrays_tests
