// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "catalogue/operation/operation.h"
#include "report/uses.h"

/// Answers as one says them.
namespace touchstone::report {

/// An answer's word in plain words: "left" of orientation is "left of the line". A word without a phrase stands as it
/// is, "_" a space; of several with "/" between them ("convex/ccw") each has its own.
std::string phrase(const Operation& operation, const std::string& word);

/// A complete answer: its words, then its numbers where they are few: "meeting in a point, t = 0.5, point (1, 2)".
/// `answer` is shown as it is given: exact values are not shortened here.
std::string phrase(const Operation& operation, const Json& answer);

/// What was answered instead of what: “on it” where the truth is “left of the line”.
std::string phrase(const Operation& operation, const Way& way);

}  // namespace touchstone::report
