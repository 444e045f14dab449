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

/// Two engines, of which the answers to the same questions are compared with each other: two builds, two compilers,
/// before and after an optimisation.
namespace touchstone::audit {

/// A question on which they part, and the verdict on each.
struct Parting {
  Question question;
  std::string family;       ///< or call site
  std::uint64_t index = 0;  ///< within it, or of the call
  Json first, second;       ///< as answered; null where there was no answer
  Judgement of_first, of_second;
};

/// One operation. Of two answers that differ both may be right: numbers within the stated bound, a touch that each
/// convention has its own answer to.
struct PartedOperation {
  std::string operation;
  std::uint64_t asked = 0;
  std::uint64_t not_asked = 0;  ///< because an engine had been given up, or the run was stopped
  struct Kind {
    std::uint64_t count = 0;
    std::optional<Parting> smallest;
  };
  std::map<std::pair<Verdict, Verdict>, Kind> parted;

  std::uint64_t count() const;
  void add(Parting parting);
  void merge(PartedOperation other);
};

/// Whether two replies are the same answer, to the bit of every number and however it is written, or the same lack of
/// one.
bool same_reply(const Operation& operation, const Reply& a, const Reply& b);

/// The two engines as one job asks them.
struct EnginePair {
  std::unique_ptr<Engine> first, second;
};

struct AgainstOptions {
  std::vector<const Operation*> operations;  ///< those that one of the two does not declare are left out
  std::uint64_t cases = 20000, seed = 1;
  bool by_cost = false;
  int jobs = 1;
  std::function<EnginePair()> engines;  ///< called once a job
  /// How long the smallest question of each kind is made smaller, in seconds; 0: it stays as drawn.
  double seconds_to_reduce = 0;
  std::function<void(const std::string&, std::uint64_t)> progress{};  ///< hears (operation, cases done)
};

/// Asks both the same drawn questions. What it finds does not depend on the jobs, but for what is made smaller within
/// a time. Throws EngineError where the engines have no operation in common.
std::vector<PartedOperation> ask_against(const AgainstOptions& options, const std::atomic<bool>& stop);

/// Recorded calls asked of an engine: `first` is what the log says.
std::vector<PartedOperation> log_against(const std::vector<std::string>& files, const AgainstOptions& options,
                                         const std::atomic<bool>& stop);

}  // namespace touchstone::audit
