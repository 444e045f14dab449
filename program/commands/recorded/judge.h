// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "program/runs/audit_gate.h"
#include "program/terminal/names.h"

namespace touchstone::program {

struct JudgeCommand {
  std::string program = "touchstone";  ///< the name by which it was called
  std::vector<std::string> files;      ///< logs; "-" is standard input
  std::string operations = "all";      ///< "all" or names separated by commas
  std::string boundary;                ///< of the recorded functions; empty: from the log
  std::optional<double> tolerance;     ///< likewise
  std::string pairs, columns;          ///< an operation: the files are questions to `engine` instead
  std::string engine;                  ///< command
  std::string against;                 ///< command of an engine that is asked the same questions; empty: none
  double timeout = usual_timeout;
  int jobs = 0;       ///< 0: as many as the machine has
  std::string shard;  ///< "I/N"; empty: from the launcher, if one started this
  std::string json_file, report_directory;
  bool summary = false;  ///< a row for each operation
  GateCommand gate;
};

/// Compares the recorded answers with the truth (audit/judging). Exit codes are those of `audit`.
int judge_command(const JudgeCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
