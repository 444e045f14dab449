// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalogue/operation.h"

/// What an audit has counted. Tallies of disjoint sets of cases merge; the order in which cases were asked leaves no
/// trace.
namespace touchstone::audit {

struct Finding {
  Question question;
  Judgement judgement;
  Json answer;              ///< what the engine said; null if nothing
  std::uint64_t index = 0;  ///< of the case within its operation and family
};

/// One operation and family.
struct Cell {
  std::array<std::uint64_t, verdict_count> counts{};
  std::array<std::optional<Finding>, verdict_count> smallest{};  ///< the smallest input of each verdict but `agree`
  double worst_ulps = 0;                                         ///< over the answers whose decision is right
  std::map<std::string, std::uint64_t> outcomes;                 ///< how often the truth was what
  std::uint64_t touches_closed = 0, touches_open = 0;  ///< touches answered as closed sets do, as open sets do
  std::uint64_t surplus = 0;                           ///< elements that answers which must cover hold beyond the truth
  std::uint64_t refused = 0;                           ///< drawn, but outside the contract: not a case
  std::uint64_t not_asked = 0;                         ///< the engine had been given up before their turn: no cases
  std::string given_up;                        ///< why, in the engine's or our words; empty where all were asked
  std::map<std::string, std::uint64_t> rules;  ///< how often which rule refused it, without particulars ("simple")

  std::uint64_t cases() const;
  std::uint64_t count(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t findings() const;  ///< cases whose verdict is a finding
  void refuse(const std::string& rule);
  void merge(const Cell& other);
};

/// "Smaller" for findings: fewer digits to write the numbers out in full, then smaller exponents, then the bits; a
/// total order.
bool smaller(const Question& a, const Question& b);

struct OperationTally {
  std::string operation;
  std::vector<std::pair<std::string, Cell>> families;  ///< in the operation's order
  Cell total() const;
  /// Touch treated as contact here and not there: a finding of its own.
  bool inconsistent_convention() const;
};

/// Of an exhaustive run: the grid, into how many shards it is cut, and which of them are counted here. size 0: cases
/// were drawn.
struct Grid {
  std::uint64_t size = 0, shards = 1;
  std::vector<std::uint64_t> done;  ///< ascending
};

struct Tally {
  Declaration declaration;
  std::uint64_t seed = 0, cases = 0;  ///< per operation, as asked for
  Grid grid;
  std::vector<OperationTally> operations;
  std::vector<OperationTally> robust;  ///< the same questions asked to robust
  bool interrupted = false;

  bool has_findings() const;
  /// Throws InvalidInput where the two are of different engines or grids, or count the same cases. Of two seeds the
  /// smaller stays.
  void merge(const Tally& other);
};

}  // namespace touchstone::audit
