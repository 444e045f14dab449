// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "audit/counting/judged.h"
#include "audit/time_limit.h"

namespace touchstone::audit {

struct AuditOptions {
  std::vector<const Operation*> operations;
  std::vector<std::string> families;  ///< empty: all
  std::uint64_t cases = 20000;        ///< per operation, spread over its families in turn
  bool by_cost = false;               ///< fewer for expensive operations (audit/counting/cases_of.h); within one shard
  std::uint64_t seed = 1;
  Limits limits;               ///< limits of ordinary numbers
  bool ordinary_only = false;  ///< extreme questions are drawn and skipped
  /// Time limit per operation, checked before each answer and while findings are shrunk; 0: no limit. With a limit the
  /// number of cases depends on the machine.
  double seconds = 0;
  std::function<double()> clock = TimeLimit::seconds_of_machine;
  int jobs = 1;
  std::uint64_t shard = 1, shards = 1;  ///< asks only the I-th of N shares of each operation's cases
  /// The tally so far of an interrupted audit with these options, from `after_operation`: its operations are not asked
  /// again.
  std::optional<Tally> counted{};
  std::function<void(const Tally&)> after_operation{};  ///< called with the tally so far
  /// Called with the number of an operation's findings that have been shrunk, and their total; from any thread.
  std::function<void(const Operation&, std::size_t, std::size_t)> smaller{};
  /// Makes a fresh engine; called once per job. Empty: our reference in double.
  std::function<std::unique_ptr<Engine>()> engine;
};

/// Asks the engine and robust the same questions, for the operations that the engine declares; judges both by the
/// oracle and shrinks the findings. The same options give the same tally whatever `jobs` is. `stop` ends the run early
/// and returns the tally so far; `progress` is called with (operation, cases done).
Tally run_audit(const AuditOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string&, std::uint64_t)>& progress);

}  // namespace touchstone::audit
