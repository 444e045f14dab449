// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "audit/logs/recorded_call.h"
#include "program/terminal/names.h"

namespace touchstone::program {

struct LogConvertCommand {
  std::string in, out;
  std::string to;  ///< "json" or "binary"; empty: the other form than the log's
};

/// Prints the contents of a log besides its calls, one line each.
void print_account(const audit::LogAccount& account, std::ostream& out);

int log_show_command(const std::vector<std::string>& files, std::ostream& out);

/// Standard output is `out`. Returns bad_usage if the log has calls that no operation takes: they are not written.
int log_convert_command(const LogConvertCommand& command, std::ostream& out, std::ostream& err);

}  // namespace touchstone::program
