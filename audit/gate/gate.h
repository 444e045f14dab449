// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "audit/counting/tally.h"

/// Decides whether an audit passes in a test run: which findings fail it, and which are known and accepted.
namespace touchstone::audit {

/// The causes that a gate counts: the verdicts except `agree`, `rounding` in its two kinds, and findings without a
/// verdict.
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
  inconsistent_convention,  ///< touches treated inconsistently: one finding of an operation, without a family
  surplus,                  ///< more listed than --max-surplus allows: likewise
};
inline constexpr std::size_t cause_count = 11;
inline constexpr std::array<const char*, cause_count> cause_names{
    "cancellation", "out_of_range", "algorithm",   "inexact",   "invalid",
    "convention",   "tolerance",    "unsupported", "not_asked", "inconsistent_convention",
    "surplus"};
inline const char* name_of(Cause cause) { return cause_names[static_cast<std::size_t>(cause)]; }

/// The causes for which an audit without a gate exits with 1.
std::set<Cause> usual_causes();
/// Parses "algorithm,invalid"; "rounding" means both of its kinds, "none" none. Throws InvalidInput, which lists the
/// possible causes.
std::set<Cause> causes_named(const std::string& names);

/// The number of findings of a cause in a family of an operation.
struct Found {
  std::string operation, family;
  Cause cause = Cause::algorithm;
  std::uint64_t findings = 0, cases = 0;
};
/// In the order of the tally, then of the causes; none with 0 findings.
std::vector<Found> found_in(const Tally& tally, const std::set<Cause>& causes);

/// Findings that were accepted once and for all.
struct Baseline {
  std::string engine;  ///< for the reader; another version of it is compared with the same baseline
  std::uint64_t seed = 0;
  std::vector<Found> known;
};
Baseline baseline_of(const Tally& tally, const std::set<Cause>& causes);

/// The number of these findings that is known. For the same questions (seed and number of cases) at most as many as at
/// that time. For other questions as many as expected at that rate, plus three standard deviations.
std::uint64_t accepted(const Found& found, std::uint64_t seed, const Baseline& baseline);

struct Gate {
  std::set<Cause> causes = usual_causes();
  std::optional<Baseline> baseline;
  /// The allowed share of unknown findings among an operation's cases.
  double max_rate = 0;
};

struct GateEntry {
  Found found;
  std::uint64_t known = 0;  ///< of its findings
  bool fails = false;
};

struct GateResult {
  std::vector<GateEntry> entries;  ///< with the gate's causes
  std::uint64_t gone = 0;          ///< entries of the baseline that were asked and no longer found
  std::uint64_t robust = 0;        ///< wrong answers of robust: then no gate passes
  bool passed() const;
};
GateResult held_against(const Tally& tally, const Gate& gate);

/// Returns "gate: passed; 12 findings are known
/// ", or the entries that fail it, one per line, with the shell command that repeats the example.
std::string gate_in_words(const Tally& tally, const GateResult& result);

}  // namespace touchstone::audit
