// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "program/terminal/uses.h"

/// A run divided into parts, for any number of machines.
namespace touchstone::program {

/// The I-th of N parts of a run, counted from 1.
struct Shard {
  std::uint64_t index = 1, of = 1;
  std::string from{};  ///< the source: --shard or a launcher; empty: none, and the run is undivided

  bool named() const { return !from.empty(); }
  /// "3/10"
  std::string text() const { return std::to_string(index) + "/" + std::to_string(of); }
};

/// The value of an environment variable, or nullptr.
using Variable = std::function<const char*(const char*)>;

/// The shard of --shard I/N; if that is empty, of the launcher that started this process: a Slurm array, a Kubernetes
/// indexed job, GNU parallel, Open MPI, or another launcher with the interface PMI. A launcher that does not give the
/// number of tasks counts only if TOUCHSTONE_SHARDS does; with that, the tasks of a Slurm array count from 1, so that
/// some of them can be resubmitted. Throws UsageError.
Shard shard_of(
    const std::string& option, const Variable& variable = [](const char* name) { return std::getenv(name); });

/// Reports the shard if a launcher selected it.
void tell(const Shard& shard, std::ostream& err);
/// "shard 3/10 (Slurm array)"
std::string in_words(const Shard& shard);

/// Consecutive indices: first <= index < last.
struct Share {
  std::uint64_t first = 0, last = 0;
  std::uint64_t size() const { return last - first; }
  friend bool operator==(const Share&, const Share&) = default;
};

/// The indices of a shard. All shards together hold each of the indices below `total` once.
Share share_of(std::uint64_t total, const Shard& shard);

/// "2 of 8 shards are missing: 3, 7"; "" if none is. `done` is ascending.
std::string missing_shards(std::uint64_t shards, const std::vector<std::uint64_t>& done);

}  // namespace touchstone::program
