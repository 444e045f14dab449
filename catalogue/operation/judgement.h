// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/examination.h"

/// The judgement of an answer to an examined question. Examination keeps the judgements of our own answers.
namespace touchstone::catalogue {

Judgement judgement_of_formula(const Examination& question, bool binary32);
Judgement judgement_of_robust(const Examination& question, std::size_t environment);
Judgement judgement_of_engine(const Examination& question, const Json& answer, const Declaration& declaration);

/// Whether the formula in double is wrong, or less exact than it promises; the cause is not sought.
bool formula_errs(const Examination& question);
/// Whether the formula run in exact arithmetic is right.
bool is_right_exactly(const Examination& question);
/// Where a checker sees numbers, what it says turns on every rounding.
bool checks_numbers(const RowFunctions& row);

/// The contract's promise for the double version, tested: empty if it holds here. Where running error analysis proves
/// that rounding cannot have changed a decision, reference in double must decide as in exact arithmetic, and its
/// numbers must lie within the proved bound.
std::string broken_promise(const Examination& question);
/// What is wrong with robust's answer where a residual should be exactly zero; empty where none is.
std::string residual_complaint(const Examination& question);

}  // namespace touchstone::catalogue
