// SPDX-License-Identifier: Apache-2.0
#include "program/runs/rounds.h"

#include <algorithm>

#include "audit/parallel.h"
#include "audit/time_limit.h"

namespace touchstone::program {

std::uint64_t Rounds::run(std::uint64_t next, std::uint64_t last, const std::function<void(std::size_t, Share)>& work) {
  const double began = TimeLimit::seconds_of_machine();
  std::vector<Share> pieces;
  for (int job = 0; job < jobs_ && next < last; ++job) {
    const std::uint64_t end = next + std::min(piece_, last - next);
    pieces.push_back({next, end});
    next = end;
  }
  in_parallel(jobs_, pieces.size(), [&](std::size_t job) { work(job, pieces[job]); });
  const double took = TimeLimit::seconds_of_machine() - began;
  if (took < seconds_ / 2 && piece_ < std::uint64_t{1} << 40) piece_ *= 2;
  if (took > seconds_ * 2 && piece_ > 1) piece_ /= 2;
  return next;
}

}  // namespace touchstone::program
