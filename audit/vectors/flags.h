// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// A flag of a test vector, explained once: the kind of input that it marks and the consequence for an engine that
/// fails it.
struct Flag {
  const char* name;
  const char* meaning;
  const char* effect;
};

inline constexpr std::array<Flag, 8> vector_flags{{
    {"touch", "The shapes meet in a boundary point only.",
     "An implementation for open sets answers otherwise; that is a convention, not an error."},
    {"degenerate", "The margin is 0: the least change of the input can change the answer.",
     "A tolerance does not help; exact arithmetic does."},
    {"formula_rounds", "The textbook formula in double decides wrongly, in exact arithmetic rightly.",
     "A failure points at rounding."},
    {"formula_wrong", "The textbook formula decides wrongly, or is undefined, even in exact arithmetic.",
     "A failure points at a missing special case."},
    {"formula_inexact", "The textbook formula decides rightly, but a number is further off than its stated bound.",
     "A failure points at cancellation."},
    {"extreme", "A number is subnormal or beyond 2^500 in size.",
     "A failure points at overflow, underflow or flush-to-zero."},
    {"closed_ring", "The last position of a polygon repeats the first, which is not a vertex more.",
     "A failure points at an edge of length zero."},
    {"refused", "The input is outside the contract; field and rule are given.",
     "An implementation may do what it documents."},
}};

/// In terms of flags: a number that rounding spoils, however much, is `inexact`.
Verdict verdict_on_decision(const Judgement& judgement);

std::vector<std::string> flags_of(const Operation& operation, const Question& question, const Examination& examination);

}  // namespace touchstone::audit
