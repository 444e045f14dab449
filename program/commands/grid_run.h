// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <ostream>

#include "catalogue/operation/operation.h"
#include "program/commands/commands.h"
#include "program/runs/checkpoint.h"
#include "program/runs/shard.h"
#include "program/terminal/progress.h"

namespace touchstone::program {

/// One shard of the configurations of a grid, continuing where an interrupted run ended.
class GridRun {
 public:
  GridRun(const Operation& operation, const ExhaustCommand& command, const Shard& shard, std::ostream& err);

  /// The counts of the interrupted run; null if there is none.
  Json counted() const;

  /// Calls work(job, share) until everything is done, and state() when it is time to save the counts. Returns false if
  /// it was interrupted.
  bool run(const std::function<void(std::size_t, Share)>& work, const std::function<Json()>& state);
  /// Called when the result is written.
  void finish() const { checkpoint_.remove(); }

  std::uint64_t total() const { return total_; }
  /// The finished indices.
  Share done() const { return {share_.first, next_}; }
  std::size_t jobs() const { return static_cast<std::size_t>(jobs_); }

 private:
  void tell(double seconds);

  std::uint64_t total_;
  Share share_;
  std::uint64_t next_, began_at_;
  int jobs_;
  std::ostream& err_;
  Checkpoint checkpoint_;
  Progress progress_;
};

}  // namespace touchstone::program
