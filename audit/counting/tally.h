// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "audit/counting/recorded.h"
#include "audit/uses.h"
#include "audit/version.h"
#include "catalogue/operation/operation.h"

/// The counts of an audit. Tallies of disjoint sets of cases merge; the order in which cases were asked leaves no
/// trace.
namespace touchstone::audit {

/// The magnitude of a question's numbers.
enum class Range {
  ordinary,  ///< each is 0 or within the limits
  extreme,   ///< one is not
};
inline constexpr std::size_t range_count = 2;
inline constexpr std::array<const char*, range_count> range_names{"ordinary", "extreme"};
inline const char* name_of(Range range) { return range_names[static_cast<std::size_t>(range)]; }

/// The range of numbers of ordinary magnitude, apart from 0: least <= |number| <= most.
struct Limits {
  double least = 0x1p-100, most = 0x1p100;
  friend bool operator==(const Limits&, const Limits&) = default;
};
Range range_of(const Question& question, const Limits& limits = {});

struct Finding {
  Question question;
  Judgement judgement;
  Json answer;              ///< the engine's answer; null if there was none
  std::uint64_t index = 0;  ///< of the case within its operation and family
  Range range = Range::ordinary;
  std::size_t features = 0;  ///< number of degenerate ones (audit/counting/generic.h)
  /// Its question as examined by the shrinker or on first use; copies share it.
  std::shared_ptr<Once<std::unique_ptr<const Examination>>> examined =
      std::make_shared<Once<std::unique_ptr<const Examination>>>();
  std::string vector{};  ///< the id of the test vector; empty: drawn

  /// Throws InvalidInput if the oracle refuses the question.
  const Examination& examination(const Operation& operation) const;
};

/// The verdict, or for `rounding` its kind: "cancellation" or "out_of_range".
const char* cause_of(const Judgement& judgement);

/// True if `a` is the better example of one outcome: ordinary numbers before extreme ones, then fewer degenerate
/// features, then the smaller question, then the earlier case. A total order of the findings of one cell.
bool shown_before(const Finding& a, const Finding& b);

/// Answers without enumerators, as named in an outcome.
inline constexpr const char *no_valid_answer = "no valid answer", *no_answer = "no answer";

/// An outcome: the verdict, the truth and the answer, both in enumerators of the operation ("boundary", "convex/ccw").
/// A truth without any is "value", and "refused" if robust and oracle refuse differently. An answer may also be
/// "value", "true" or "false", "no valid answer" if the verdict is `invalid`, "no answer" if it is `unsupported`.
struct JudgedOutcome {
  Verdict verdict = Verdict::agree;
  std::string truth, answer;
  friend bool operator==(const JudgedOutcome&, const JudgedOutcome&) = default;
  friend bool operator<(const JudgedOutcome& a, const JudgedOutcome& b) {
    return std::tie(a.verdict, a.truth, a.answer) < std::tie(b.verdict, b.truth, b.answer);
  }
};

/// A number of cases for each Range.
using ByRange = std::array<std::uint64_t, range_count>;
inline std::uint64_t both(const ByRange& counts) { return counts[0] + counts[1]; }

struct OutcomeCount {
  ByRange cases{};
  ByRange out_of_range{};          ///< for `rounding`: by overflow or underflow; the rest is by cancellation
  std::optional<Finding> example;  ///< the best, by shown_before; none for `agree` and `unsupported`

  void merge(const OutcomeCount& other);
};

/// One operation and family, or for recorded calls: operation and call site.
struct Cell {
  std::map<JudgedOutcome, OutcomeCount> outcomes;
  double worst_ulps = 0;                               ///< over the answers whose decisions are all right
  std::uint64_t touches_closed = 0, touches_open = 0;  ///< clear touches answered as closed sets do, as open ones
  std::uint64_t surplus = 0;                           ///< clear touches answered as by closed sets, as by open ones
  std::uint64_t apart = 0;                             ///< possible elements beyond it
  std::uint64_t refused = 0;                           ///< drawn, but outside the contract: not a case
  std::uint64_t hash = 0;                              ///< of the truths and answers: a sum over the cases
  std::uint64_t left_out = 0;                          ///< drawn, but extreme while only ordinary questions are asked
  /// At ordinary magnitude: findings except rounding with a direction that has a component of 0, right answers without
  /// one.
  std::uint64_t found_on_axis = 0, right_off_axis = 0;
  std::uint64_t other_nearest = 0;             ///< right answers that resolve a tie otherwise than the truth
  std::uint64_t other_alternative = 0;         ///< drawn, but of an alternative that the engine does not answer
  std::uint64_t not_asked = 0;                 ///< the engine had been given up before their turn: not cases
  std::string given_up;                        ///< the reason, from the engine or from us; empty if all were asked
  std::map<std::string, std::uint64_t> rules;  ///< how often each rule refused it, without particulars ("simple")
  Recorded recorded{};                         ///< for recorded calls; otherwise empty

  double surplus_rate() const { return apart == 0 ? 0 : static_cast<double>(surplus) / static_cast<double>(apart); }
  std::uint64_t cases() const;
  std::uint64_t cases(Range range) const;
  std::uint64_t count(Verdict verdict) const;
  std::uint64_t count(Verdict verdict, Range range) const;
  std::array<std::uint64_t, verdict_count> counts() const;
  std::uint64_t answered() const;  ///< cases except `unsupported`
  std::uint64_t answered(Range range) const;
  std::uint64_t wrong() const;  ///< `rounding`, `algorithm` and `invalid`: the answer is useless
  std::uint64_t wrong(Range range) const;
  bool nothing_right() const;      ///< for so many answers that the connection must be checked first
  std::uint64_t findings() const;  ///< cases whose verdict is a finding: wrong or `inexact`
  std::uint64_t findings(Range range) const;
  ByRange by_range(Verdict verdict) const;
  ByRange out_of_range() const;  ///< of `rounding`: by overflow or underflow
  ByRange cancellation() const;  ///< of `rounding`: the rest
  /// The count of each truth.
  std::map<std::string, std::uint64_t> truths() const;
  /// The count of each answer (second) to each truth (first), whatever the verdict.
  std::map<std::pair<std::string, std::string>, ByRange> confusion() const;
  /// The best example of a verdict, over its outcomes; nullptr if there is none.
  const Finding* example(Verdict verdict) const;

  /// A cell of cases of which only the verdict is known.
  static Cell of(const std::array<std::uint64_t, verdict_count>& counts);

  void refuse(const std::string& rule);
  void merge(const Cell& other);

 private:
  ByRange by_range() const;
};

/// Orders findings: fewer digits to write the numbers out in full, then smaller exponents, then the bits; a total
/// order.
bool smaller(const Question& a, const Question& b);

struct OperationTally {
  std::string operation;
  std::vector<std::pair<std::string, Cell>> families;  ///< in the operation's order
  Cell total() const;
  /// Touch treated as contact in some cases and not in others: a finding of its own.
  bool inconsistent_convention() const;
  /// More listed beyond the truth than a broad phase should: a finding of its own.
  bool too_much_surplus(double most) const { return total().surplus_rate() > most; }
};

/// The number of shards of the run, and those counted here; for an exhaustive run the grid, too. size 0: cases were
/// drawn, and if they are in one part `done` is empty.
struct Grid {
  std::uint64_t size = 0, shards = 1;
  std::vector<std::uint64_t> done;  ///< ascending
};

/// An engine that lists everything has a rate of 1; sorting along one axis, the simplest broad phase, has about 0.4 on
/// these questions.
inline constexpr double usual_surplus = 0.75;

/// Text to find a finding again, and to ask a foreign engine again, as a shell command.
struct Repeat {
  std::string program = "touchstone";
  std::string options;    ///< "--engine 'python3 engine.py'"; empty if the program is the engine's own
  bool recorded = false;  ///< for recorded calls: families are call sites, cases are calls
};

struct Tally {
  std::string version = version_number;
  Declaration declaration;
  Repeat repeat;                      ///< of merged tallies the first one's
  std::vector<std::string> logs{};    ///< if recorded calls were judged: the files; families are call sites then
  std::uint64_t seed = 0, cases = 0;  ///< per operation, as requested
  bool by_cost = false;               ///< fewer for expensive operations (audit/counting/cases_of.h)
  Grid grid;
  Limits limits;                        ///< that separate ordinary questions from extreme ones
  double max_surplus = usual_surplus;   ///< the allowed share of `apart` in lists
  std::vector<std::string> undeclared;  ///< operations that were requested and that the engine does not declare
  std::vector<OperationTally> operations;
  std::vector<OperationTally> robust;  ///< the same questions asked to robust
  bool interrupted = false;

  bool has_findings() const;
  /// True if extreme questions were drawn and skipped.
  bool ordinary_only() const;
  /// Throws InvalidInput if the two are of different engines, grids or limits, or count the same cases. The smaller of
  /// two seeds is kept.
  void merge(const Tally& other);
};

}  // namespace touchstone::audit
