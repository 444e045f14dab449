// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"

/// Compares the answers of two engines to the same questions: two builds, two compilers, before and after an
/// optimisation.
namespace touchstone::audit {

/// A question on which they differ, and the verdict on each.
struct Parting {
  Question question;
  std::string family;       ///< or call site
  std::uint64_t index = 0;  ///< its number within it, or that of the call
  Json first, second;       ///< as answered; null without an answer
  Judgement of_first, of_second;
};

/// The result for one operation. Two different answers may both be right: numbers within the stated bound, or a
/// touch to which each convention has its own answer.
struct PartedOperation {
  std::string operation;
  std::uint64_t asked = 0;
  std::uint64_t not_asked = 0;  ///< because an engine had been given up, or the run was interrupted
  struct Kind {
    std::uint64_t count = 0;
    std::optional<Parting> smallest;
  };
  std::map<std::pair<Verdict, Verdict>, Kind> parted;

  std::uint64_t count() const;
  void add(Parting parting);
  void merge(PartedOperation other);
};

/// True if two replies are the same answer, to the bit of every number and however it is written, or the same lack of
/// one.
bool same_reply(const Operation& operation, const Reply& a, const Reply& b);

/// The two engines of one job.
struct EnginePair {
  std::unique_ptr<Engine> first, second;
};

struct AgainstOptions {
  std::vector<const Operation*> operations;  ///< those that one of the two does not declare are left out
  std::uint64_t cases = 20000, seed = 1;
  bool by_cost = false;
  int jobs = 1;
  std::function<EnginePair()> engines;  ///< called once per job
  /// Time in seconds for reducing the smallest question of each kind; 0: it stays as drawn.
  double seconds_to_reduce = 0;
  std::function<void(const std::string&, std::uint64_t)> progress{};  ///< called with (operation, cases done)
};

/// Asks both the same drawn questions. The result does not depend on the jobs, except for questions that are reduced
/// within a time limit. Throws EngineError if the engines have no operation in common.
std::vector<PartedOperation> ask_against(const AgainstOptions& options, const std::atomic<bool>& stop);

/// Asks an engine the questions of recorded calls: `first` is the answer in the log.
std::vector<PartedOperation> log_against(const std::vector<std::string>& files, const AgainstOptions& options,
                                         const std::atomic<bool>& stop);

}  // namespace touchstone::audit
