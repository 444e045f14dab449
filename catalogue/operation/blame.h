// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/compare.h"
#include "catalogue/operation/examination.h"

/// Answers against the truth, and the cause of a wrong decision (docs/judging.md, Who is to blame).
namespace touchstone::catalogue {

/// Compares by the row's checker, as a list that must cover, or slot by slot. Defects and surplus go into the
/// judgement.
Comparison compared(const Examination& question, const EncodedValue<double>& answer, Reading reading, bool binary32,
                    Judgement& judgement);
/// The same for the textbook formula.
Comparison compared_formula(const Examination& question, bool binary32, Judgement& judgement);

/// True if the decision turns on products so small that formulas that compare products lose them.
bool products_underflow(const Examination& question, bool binary32);

/// True if an engine that promises to list only the truth lists more.
bool lists_too_much(const Judgement& judgement, const Declaration& declaration);

/// The name of a textbook formula other than the deck's, which an engine may use, that is uncertain of its decision in
/// that number type, and decides wrongly or, on a touch, rightly by luck; nullptr if there is none.
const char* standard_formula_that_rounds(const Examination& question, bool binary32);

/// For a foreign implementation rounding is to blame if the question is near a touch, or if the textbook formula, or
/// another one, is uncertain of its decision in the engine's own number type (running error analysis) and decides
/// wrongly too; for numbers that a checker refuses, if the formula's are refused for rounding. If all of them come out
/// right, the number type was good enough, and the choice of another formula is to blame. answer: nullptr if it was a
/// plain true or false.
bool rounding_is_to_blame(const Examination& question, const EncodedValue<double>* answer,
                          const Declaration& declaration);

/// True if no textbook formula is uncertain of its decision; false for a question so long that this would take too much
/// time.
bool is_clear(const Examination& question, bool binary32);

}  // namespace touchstone::catalogue
