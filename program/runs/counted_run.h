// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "audit/version.h"
#include "catalogue/codec/json.h"
#include "program/runs/shard.h"

/// The counts of runs that only count: soaks, and decisions on a grid. Shards of one run merge.
namespace touchstone::program {

/// The counts of one operation.
struct Counts {
  std::string operation;
  std::vector<Share> counted;                     ///< ascending, with gaps between them
  std::map<std::string, std::uint64_t> outcomes;  ///< counts of truths; "refused" if the input is outside the contract
  std::map<std::string, std::uint64_t> of_grid;   ///< for the full grid, if a case represents several; otherwise empty
  std::uint64_t wrong = 0;                        ///< the number of these on which robust and oracle differ
  std::uint64_t hash = 0;  ///< a sum over the cases, so that neither order nor division leaves a trace
  Json first_wrong;        ///< that of the least index: index, input, and further details; null if none is wrong

  std::uint64_t cases() const;
  /// Throws InvalidInput if both have counted the same case.
  void add(const Counts& other);
};

struct CountedRun {
  std::string kind;  ///< "soak" or "decisions"
  std::string version = version_number;
  std::uint64_t grid = 0, seed = 0;  ///< one for decisions, the other for a soak
  double seconds = 0;                ///< a shard asks as much of its share as it can in that time; 0: all
  std::uint64_t of = 0;              ///< number of indices of each operation, in all shards together
  std::uint64_t shards = 1;
  std::vector<std::uint64_t> done;  ///< ascending
  std::vector<Counts> operations;

  std::uint64_t wrong() const;
  /// Throws InvalidInput if the other is of another run or counts the same cases. With the last shard it becomes an
  /// undivided run.
  void merge(const CountedRun& other);
};

Json json_of(const CountedRun& run);
/// Throws InvalidInput naming the field, also if the sums do not add up.
CountedRun read_counted_run(const Json& json);
/// Throws InvalidInput unless the counted cases are those of the finished shards; with a time limit, some of each.
void require_shares(const CountedRun& run);

/// Throws InvalidInput if everything was asked and, with symmetries, does not represent the full grid.
void require_full_grid(const CountedRun& run);

/// One row per operation, and any error with the command that asks it again.
std::string table_of(const CountedRun& run);

}  // namespace touchstone::program
