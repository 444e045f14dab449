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
  std::uint64_t cases = 20000;        ///< per operation, dealt out over its families in turn
  bool by_cost = false;  ///< fewer of operations that cost much (audit/counting/cases_of.h); of one shard alone
  std::uint64_t seed = 1;
  Limits limits;               ///< of ordinary numbers
  bool ordinary_only = false;  ///< extreme questions are drawn and left out
  /// Per operation, looked at before each answer, also while findings are made smaller; 0: no limit. With a limit the
  /// number of cases depends on the machine.
  double seconds = 0;
  std::function<double()> clock = TimeLimit::seconds_of_machine;
  int jobs = 1;
  std::uint64_t shard = 1, shards = 1;  ///< of each operation's cases only these: the I-th of N shares
  /// An audit with these options that was stopped, from `after_operation`: its operations are not asked again.
  std::optional<Tally> counted{};
  std::function<void(const Tally&)> after_operation{};  ///< hears what is counted so far
  /// Hears how many findings of an operation have been made smaller, and of how many; from any thread.
  std::function<void(const Operation&, std::size_t, std::size_t)> smaller{};
  /// A fresh engine; called once a job. Empty: our reference in double.
  std::function<std::unique_ptr<Engine>()> engine;
};

/// Asks the engine and robust the same questions, of the operations that the engine declares; judges both by the oracle
/// and shrinks what it found. The same options give the same tally whatever `jobs` is. `stop` ends the run early with
/// what there is; `progress` hears (operation, cases done).
Tally run_audit(const AuditOptions& options, const std::atomic<bool>& stop,
                const std::function<void(const std::string&, std::uint64_t)>& progress);

}  // namespace touchstone::audit
