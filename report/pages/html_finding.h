// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/counting/tally.h"
#include "report/words/ways.h"
#include "report/words/wording.h"

namespace touchstone::report {

/// An outcome as a card with its example: the truth and the answer in words, drawn next to one another if they can be
/// drawn, each implementation's answer and its explanation, the numbers, the command, the certificate.
std::string finding_card(const Operation& operation, const OperationOutcome& shown, const Declaration& declaration,
                         Speaker speaker, const Repeat& repeat);

/// A drawing of a question of ordinary magnitude on which the textbook formula is right, for comparison with the
/// findings. Among the first few that the families draw, the one with the fewest degenerate features; empty if none can
/// be drawn.
std::string right_case(const Operation& operation);

/// The author of an answer, as the beginning of a caption: "Formula", "Robust", "my engine 1.0".
std::string name_of(Speaker speaker, const Declaration& declaration);

}  // namespace touchstone::report
