// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "audit/version.h"
#include "catalogue/codec/json.h"
#include "program/runs/shard.h"

/// What runs that only count have counted: soaks, and decisions on a grid. Shards of one run merge.
namespace touchstone::program {

/// Of one operation.
struct Counts {
  std::string operation;
  std::vector<Share> counted;                     ///< ascending, with gaps between them
  std::map<std::string, std::uint64_t> outcomes;  ///< what was true; "refused" where the input is outside the contract
  std::map<std::string, std::uint64_t> of_grid;   ///< of the whole grid, where one case stands for several; else empty
  std::uint64_t wrong = 0;                        ///< of these, how often robust and oracle differ
  std::uint64_t hash = 0;  ///< a sum over the cases, so that neither order nor cut leaves a trace
  Json first_wrong;        ///< that of the least index: index, input, and what else is known; null where none is

  std::uint64_t cases() const;
  /// Throws InvalidInput where both have counted the same case.
  void add(const Counts& other);
};

struct CountedRun {
  std::string kind;  ///< "soak" or "decisions"
  std::string version = version_number;
  std::uint64_t grid = 0, seed = 0;  ///< of decisions the one, of a soak the other
  double seconds = 0;                ///< a shard asks as much of its share as it can in that time; 0: all
  std::uint64_t of = 0;              ///< indices of each operation, in all shards together
  std::uint64_t shards = 1;
  std::vector<std::uint64_t> done;  ///< ascending
  std::vector<Counts> operations;

  std::uint64_t wrong() const;
  /// Throws InvalidInput where the other is of another run or counts the same cases. With the last shard it becomes
  /// a run in one part.
  void merge(const CountedRun& other);
};

Json json_of(const CountedRun& run);
/// Throws InvalidInput naming the field; also where the sums do not add up.
CountedRun read_counted_run(const Json& json);
/// Throws InvalidInput unless the cases counted are those of the shards done; with a limit of time, some of each.
void require_shares(const CountedRun& run);

/// Throws InvalidInput where all was asked and, with symmetries, that is not the whole grid.
void require_whole_grid(const CountedRun& run);

/// A row an operation, and what is wrong with the line that asks it again.
std::string table_of(const CountedRun& run);

}  // namespace touchstone::program
