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

/// One shard of the configurations of a grid, from where a run that was stopped had come to.
class GridRun {
 public:
  GridRun(const Operation& operation, const ExhaustCommand& command, const Shard& shard, std::ostream& err);

  /// What the run that was stopped had counted; null if there is none.
  Json counted() const;

  /// Calls work(job, share) until all is done, and state() where it is time to keep what has been counted. False where
  /// it was interrupted.
  bool run(const std::function<void(std::size_t, Share)>& work, const std::function<Json()>& state);
  /// The result is written.
  void finish() const { checkpoint_.remove(); }

  std::uint64_t total() const { return total_; }
  /// The indices that are done.
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
