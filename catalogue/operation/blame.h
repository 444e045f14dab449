// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/judge/compare.h"
#include "catalogue/operation/examination.h"

/// Answers against the truth, and what a wrong decision is laid to (docs/judging.md, Who is to blame).
namespace touchstone::catalogue {

/// By the row's checker, as a list that must cover, or slot by slot. What is wrong or too much goes into the judgement.
Comparison compared(const Examination& question, const EncodedValue<double>& answer, Reading reading, bool binary32,
                    Judgement& judgement);
/// The same of the textbook formula.
Comparison compared_formula(const Examination& question, bool binary32, Judgement& judgement);

/// The decision turns on products so small that formulas that compare products lose them.
bool products_underflow(const Examination& question, bool binary32);

/// More than the truth, of an engine that promises to list that alone.
bool lists_too_much(const Judgement& judgement, const Declaration& declaration);

/// The name of a formula of textbooks other than the deck's, which an engine may have, that is not sure of its decision
/// in that number type, and decides wrongly or, on a touch, rightly by luck; nullptr where there is none.
const char* standard_formula_that_rounds(const Examination& question, bool binary32);

/// For a foreign implementation rounding is to blame where the question is near a touch, or where the textbook formula,
/// or another of textbooks, in the engine's own number type is not sure of its decision (running error analysis) and
/// decides wrongly too; of numbers that a checker refuses, where the formula's are refused for rounding. Where all of
/// them come out right, the number type was good enough, and what is to blame is the choice of another.
/// answer: nullptr where it was a plain true or false.
bool rounding_is_to_blame(const Examination& question, const EncodedValue<double>* answer,
                          const Declaration& declaration);

/// Whether no formula of textbooks is in doubt of its decision; of a question so long that this would take its time,
/// no.
bool is_clear(const Examination& question, bool binary32);

}  // namespace touchstone::catalogue
