// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "audit/uses.h"

namespace touchstone::audit {

/// Set in the environment of a Process's command, so that an engine program knows that its table is not read.
inline constexpr const char* started_as_engine = "TOUCHSTONE_STARTED_AS_ENGINE";

/// A command run by the shell in a process group of its own, on Windows a program with its arguments in a job of its
/// own. Its three streams are piped, and nothing here blocks except `wait_for`; the entire group is killed with this
/// object. In process_posix.cpp and process_windows.cpp.
class Process {
 public:
  /// Throws std::system_error if the shell itself, on Windows a program that exists, cannot be started.
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
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace touchstone::audit
