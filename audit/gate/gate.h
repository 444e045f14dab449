// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "audit/counting/tally.h"

/// Whether an audit passes in a test run: which findings fail it, and which are known and accepted.
namespace touchstone::audit {

/// What a gate counts: the verdicts but `agree`, `rounding` in its two kinds, and what has no verdict.
enum class Cause {
  cancellation,  ///< rounding
  out_of_range,  ///< rounding: overflow or underflow
  algorithm,
  inexact,
  invalid,
  convention,
  tolerance,
  unsupported,
  not_asked,                ///< the engine was given up before these questions
  inconsistent_convention,  ///< touches treated inconsistently: one finding of an operation, of no family
  surplus,                  ///< more listed than --max-surplus allows: likewise
};
inline constexpr std::size_t cause_count = 11;
inline constexpr std::array<const char*, cause_count> cause_names{
    "cancellation", "out_of_range", "algorithm",   "inexact",   "invalid",
    "convention",   "tolerance",    "unsupported", "not_asked", "inconsistent_convention",
    "surplus"};
inline const char* name_of(Cause cause) { return cause_names[static_cast<std::size_t>(cause)]; }

/// What makes an audit without a gate exit with 1.
std::set<Cause> usual_causes();
/// "algorithm,invalid"; "rounding" is both its kinds, "none" none. Throws InvalidInput naming the causes that there
/// are.
std::set<Cause> causes_named(const std::string& names);

/// How often a cause was found in a family of an operation.
struct Found {
  std::string operation, family;
  Cause cause = Cause::algorithm;
  std::uint64_t findings = 0, cases = 0;
};
/// In the order of the tally, then of the causes; none with 0 findings.
std::vector<Found> found_in(const Tally& tally, const std::set<Cause>& causes);

/// What was found once and is accepted from then on.
struct Baseline {
  std::string engine;  ///< for the reader; another version of it is held against the same baseline
  std::uint64_t seed = 0;
  std::vector<Found> known;
};
Baseline baseline_of(const Tally& tally, const std::set<Cause>& causes);

/// How many of these findings are known. The same questions (seed and number of cases) must not be answered wrongly
/// more often than then. Of other questions as many may be as are expected at that rate, and three standard deviations
/// more.
std::uint64_t accepted(const Found& found, std::uint64_t seed, const Baseline& baseline);

struct Gate {
  std::set<Cause> causes = usual_causes();
  std::optional<Baseline> baseline;
  /// The share of an operation's cases that findings which are not known may have.
  double max_rate = 0;
};

struct GateEntry {
  Found found;
  std::uint64_t known = 0;  ///< of its findings
  bool fails = false;
};

struct GateResult {
  std::vector<GateEntry> entries;  ///< of the gate's causes
  std::uint64_t gone = 0;          ///< entries of the baseline that were asked and not found any more
  std::uint64_t robust = 0;        ///< answers of robust that are wrong: then no gate passes
  bool passed() const;
};
GateResult held_against(const Tally& tally, const Gate& gate);

/// "gate: passed; 12 findings are known\n", or what fails it, an entry a line and the shell line that repeats its
/// example.
std::string gate_in_words(const Tally& tally, const GateResult& result);

}  // namespace touchstone::audit
