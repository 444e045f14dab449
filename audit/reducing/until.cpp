// SPDX-License-Identifier: Apache-2.0
#include "audit/reducing/until.h"

#include <chrono>
#include <string_view>

#include "audit/engines/process.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit {

Look Until::look(std::size_t, const Question& question) {
  using Clock = std::chrono::steady_clock;
  if (!allow_invalid_) {
    try {
      operation_.row().robust(question, 0);
    } catch (const InvalidInput&) {
      return Look::refused;
    }
  }
  const std::string line = one_line(operation_.print(question)) + "\n";
  Process process(command_);
  const auto deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(timeout_));
  std::string_view rest = line;
  std::string printed;
  for (bool open = true; open;) {
    if (Clock::now() >= deadline) return Look::fails;
    process.write(rest);
    if (rest.empty()) process.close_input();
    process.wait_for(!rest.empty(), deadline);
    open = process.read(printed);
    printed.clear();
  }
  return process.end().starts_with("exit code 0") ? Look::holds : Look::fails;
}

}  // namespace touchstone::audit
