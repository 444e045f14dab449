// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/examination.h"

/// The judgement of an answer to an examined question. Examination keeps the judgements of our own answers.
namespace touchstone::catalogue {

Judgement judgement_of_formula(const Examination& question, bool binary32);
Judgement judgement_of_robust(const Examination& question, std::size_t environment);
Judgement judgement_of_engine(const Examination& question, const Json& answer, const Declaration& declaration);

/// True if the formula in double is wrong, or less exact than promised; the cause is not determined.
bool formula_errs(const Examination& question);
/// True if the formula run in exact arithmetic is right.
bool is_right_exactly(const Examination& question);
/// True if a checker reads numbers: then its verdict depends on every rounding.
bool checks_numbers(const RowFunctions& row);

/// Tests the contract's promise for the double version: "" if it holds here. If running error analysis proves that
/// rounding cannot have changed a decision, reference in double must decide as in exact arithmetic, and its numbers
/// must lie within the proved bound.
std::string broken_promise(const Examination& question);
/// Describes a residual of robust's answer that should be exactly zero and is not; "" if there is none.
std::string residual_complaint(const Examination& question);

}  // namespace touchstone::catalogue
