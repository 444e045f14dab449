// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "program/runs/shard.h"

namespace touchstone::program {

/// Works on consecutive indices in rounds of about `seconds`, so that a long run can report progress, save its state
/// and be interrupted. In a round every job gets a piece. The sizes of pieces vary with the machine's speed, so counts
/// must not depend on where pieces end.
class Rounds {
 public:
  Rounds(int jobs, double seconds) : jobs_(jobs), seconds_(seconds) {}

  /// Calls work(job, piece) for the indices from `next` on, all below `last`, each job at most once. Returns the index
  /// after those.
  std::uint64_t run(std::uint64_t next, std::uint64_t last, const std::function<void(std::size_t, Share)>& work);

 private:
  int jobs_;
  double seconds_;
  std::uint64_t piece_ = 16;
};

}  // namespace touchstone::program
