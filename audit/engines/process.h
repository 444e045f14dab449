// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <string_view>

#include "audit/uses.h"

namespace touchstone::audit {

/// Set in the environment of a Process's command, so that an engine program knows that its table is not read.
inline constexpr const char* started_as_engine = "TOUCHSTONE_STARTED_AS_ENGINE";

/// A command run by the shell in a process group of its own. Its three streams are piped, and nothing here blocks
/// except `wait_for`; the entire group is killed with this object.
class Process {
 public:
  /// Throws std::system_error if the shell itself cannot be started.
  explicit Process(const std::string& command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Sleeps until output is available, until its input accepts more (only if `to_write`), or until `deadline`.
  void wait_for(bool to_write, std::chrono::steady_clock::time_point deadline);

  /// Writes as much as fits and removes it from `outbox`.
  void write(std::string_view& outbox);
  /// Closes its input.
  void close_input();
  /// Appends the available output. Returns false once the output has ended.
  bool read(std::string& inbox);

  /// Waits briefly for a process whose output has ended to exit; kills the group; returns how the process ended and the
  /// last line of its standard error: "signal 11 (Segmentation fault)", "exit code 1: ImportError: no module".
  std::string end();

 private:
  void read_errors();
  void kill_and_reap();

  pid_t pid_ = -1;
  int input_ = -1, output_ = -1, errors_ = -1;
  std::string last_errors_;
};

}  // namespace touchstone::audit
