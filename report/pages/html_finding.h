// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/words/ways.h"
#include "report/words/wording.h"

namespace touchstone::report {

/// A way of answering as a card with its example: the truth and what was answered in words, drawn next to one
/// another where they can be drawn, each implementation's answer and why, the numbers, the command, the certificate.
std::string finding_card(const Operation& operation, const WayOfOperation& shown, const Declaration& declaration,
                         Speaker speaker, const Repeat& repeat);

/// A question of ordinary size on which the textbook formula is right, drawn: what the findings are held against. Of
/// the first few that the families draw, the one with the fewest degenerate features; empty where none can be drawn.
std::string right_case(const Operation& operation);

/// Who answered, as a caption begins: "Formula", "Robust", "my engine 1.0".
std::string name_of(Speaker speaker, const Declaration& declaration);

/// "Right of the line" of a full answer, exact or not; where it has too many numbers for a sentence, the answer as it
/// is.
std::string sentence(const Operation& operation, const Json& answer);

}  // namespace touchstone::report
