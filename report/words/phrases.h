// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "catalogue/operation/operation.h"
#include "report/uses.h"

/// Answers in plain English.
namespace touchstone::report {

/// An answer's enumerator in plain words: "left" of orientation is "left of the line". An enumerator without a phrase
/// is unchanged, with spaces for "_"; of several with "/" between them ("convex/ccw") each has its own phrase.
std::string phrase(const Operation& operation, const std::string& word);

/// A complete answer: its enumerators, then its numbers if they are few: "meeting in a point, t = 0.5, point (1, 2)".
/// `answer` is shown as given: exact values are not shortened here.
std::string phrase(const Operation& operation, const Json& answer);

/// The same of an answer, exact or not, with its numbers shortened; if it has too many for a sentence, the answer
/// itself.
std::string sentence(const Operation& operation, const Json& answer);

/// The answer and the truth: “on it” where the truth is “left of the line”.
std::string phrase(const Operation& operation, const JudgedOutcome& outcome);

}  // namespace touchstone::report
