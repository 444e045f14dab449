// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "program/commands/commands.h"
#include "program/commands/recorded/judge.h"

namespace touchstone::program {

/// `audit --engine A --against B`: the questions on which two engines differ, which of them is right, and the smallest
/// question of each kind. Exits with 1 if they differ.
int audit_against_command(const AuditCommand& command, std::ostream& out, std::ostream& err);

/// `judge LOG --against B`: the same for recorded answers and an engine.
int judge_against_command(const JudgeCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
