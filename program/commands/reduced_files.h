// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// What a reduction came to.
struct Smallest {
  const Operation& operation;
  const Question& question;
  const Examination* examination = nullptr;  ///< nullptr: the question is outside the contract
  const Declaration* declaration = nullptr;  ///< whose answers were judged; nullptr: a command decided
  Judgement judgement{};
  Json answer;
  Json before, after;  ///< sizes
  std::string repeat;  ///< the line that asks it again
  Repeat again{};      ///< the same as a page writes it
};

/// Writes into a directory, which is made if it is not there: question.json; each mesh as an OBJ file; report.md, a
/// text for a bug report; where the question is within the contract claim.json, what `certify` checks, and
/// test_FRAMEWORK, the regression tests of `ask --as`; and picture.html, where an answer was judged. Throws UsageError
/// naming the file.
void write_reduced_files(const Smallest& smallest, const std::string& directory);

/// The text for a bug report: what is wrong, versions, the input, the answer, the truth, its certificate, how to
/// repeat.
std::string bug_report(const Smallest& smallest);

}  // namespace touchstone::program
