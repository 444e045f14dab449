// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The result of a reduction.
struct Smallest {
  const Operation& operation;
  const Question& question;
  const Examination* examination = nullptr;  ///< nullptr: the question is outside the contract
  const Declaration* declaration = nullptr;  ///< of the judged implementation; nullptr: a command decided
  Judgement judgement{};
  Json answer;
  Json before, after;  ///< sizes
  std::string repeat;  ///< the command that asks it again
  Repeat again{};      ///< the same for pages
};

/// Writes into a directory, which is created if it is missing: question.json; each mesh as an OBJ file; report.md, a
/// text for a bug report; if the question is within the contract claim.json, the input of `certify`, and
/// test_FRAMEWORK, the regression tests of `ask --as`; and picture.html, if an answer was judged. Throws UsageError
/// naming the file.
void write_reduced_files(const Smallest& smallest, const std::string& directory);

/// The text for a bug report: the defect, versions, the input, the answer, the truth, its certificate, how to reproduce
/// it.
std::string bug_report(const Smallest& smallest);

}  // namespace touchstone::program
