// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "audit/judging/call_judge.h"
#include "audit/logs/log_reader.h"

namespace touchstone::audit {

/// The counts of the first `read` calls.
struct JudgedSoFar {
  Tally tally;
  std::uint64_t read = 0;
};

struct JudgeOptions {
  std::vector<std::string> files;                 ///< logs; "-" is standard input
  std::vector<const Operation*> operations;       ///< calls of others are skipped
  std::optional<Declaration::Boundary> boundary;  ///< of the recorded functions; empty: from the log
  std::optional<double> tolerance;                ///< likewise
  Limits limits;                                  ///< limits of ordinary numbers
  int jobs = 1;
  std::uint64_t shard = 1, shards = 1;   ///< judges only calls whose number is `shard` - 1 modulo `shards`
  std::optional<JudgedSoFar> counted{};  ///< from an interrupted run: these calls are not judged again
  std::function<void(const JudgedSoFar&)> after_piece{};  ///< called with the counts so far, after this many calls
  std::uint64_t calls_of_a_piece = 1 << 20;
  /// Called with the number of calls read; from any thread.
  std::function<void(std::uint64_t)> progress{};
};

/// The counts of several judges, as a tally.
class SumOfCalls {
 public:
  void go_on_from(const Tally& tally);
  /// The indices in `sites` are those of the calls.
  void add(CallJudge& judge, const std::vector<std::string>& sites);
  /// Completes a tally whose declaration is given.
  void complete(Tally& tally);

 private:
  std::map<const Operation*, std::map<std::string, CallJudge::Counted>> counted_;
  std::uint64_t in_float_ = 0, in_double_ = 0;
};

struct JudgedLogs {
  Tally tally;                       ///< families are call sites, in the order of their names
  std::vector<LogAccount> accounts;  ///< of each file that was read
};

/// Compares the answers of recorded calls with the truth, and counts how near they were to another. The memory use does
/// not grow with the length of the logs. The same files give the same tally whatever `jobs` is. Throws LogError if a
/// file is not a log, and InvalidInput if two logs are of different engines.
JudgedLogs judge_logs(const JudgeOptions& options, const std::atomic<bool>& stop);

}  // namespace touchstone::audit
