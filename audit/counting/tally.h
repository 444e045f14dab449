// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audit/counting/recorded.h"
#include "audit/uses.h"
#include "audit/version.h"
#include "catalogue/operation/operation.h"

/// What an audit has counted. Tallies of disjoint sets of cases merge; the order in which cases were asked leaves no
/// trace.
namespace touchstone::audit {

/// How large the numbers of a question are.
enum class Range {
  ordinary,  ///< each is 0 or within the limits in size
  extreme,   ///< one is not
};
inline constexpr std::size_t range_count = 2;
inline constexpr std::array<const char*, range_count> range_names{"ordinary", "extreme"};
inline const char* name_of(Range range) { return range_names[static_cast<std::size_t>(range)]; }

/// What counts as a number of ordinary size, apart from 0: least <= |number| <= most.
struct Limits {
  double least = 0x1p-100, most = 0x1p100;
  friend bool operator==(const Limits&, const Limits&) = default;
};
Range range_of(const Question& question, const Limits& limits = {});

struct Finding {
  Question question;
  Judgement judgement;
  Json answer;              ///< what the engine answered; null if nothing
  std::uint64_t index = 0;  ///< of the case within its operation and family
  Range range = Range::ordinary;
  std::size_t features = 0;  ///< degenerate ones (audit/counting/generic.h)
  /// Its question as it was examined, by the shrinker or when first asked for; copies share it.
  std::shared_ptr<Once<std::unique_ptr<const Examination>>> examined =
      std::make_shared<Once<std::unique_ptr<const Examination>>>();
  std::string vector{};  ///< the id of the test vector that it is; empty: drawn

  /// Throws InvalidInput where the oracle refuses the question.
  const Examination& examination(const Operation& operation) const;
};

/// The verdict, or of `rounding` its kind: "cancellation" or "out_of_range".
const char* cause_of(const Judgement& judgement);

/// Whether `a` is the better example of one way of answering: ordinary numbers before extreme ones, then fewer
/// degenerate features, then the smaller question, then the earlier case. A total order of the findings of one cell.
bool shown_before(const Finding& a, const Finding& b);

/// Answers without enumerators, as a Way names them.
inline constexpr const char *no_valid_answer = "no valid answer", *no_answer = "no answer";

/// A way of answering: the verdict, the truth and the answer, both in enumerators of the operation ("boundary",
/// "convex/ccw"). Truths without any are "value", and of what robust and oracle refuse differently "refused". Answers
/// may also be "value", "true" or "false", "no valid answer" where the verdict is `invalid`, "no answer" where it is
/// `unsupported`.
struct Way {
  Verdict verdict = Verdict::agree;
  std::string truth, answer;
  auto operator<=>(const Way&) const = default;
};

/// A number of cases for each Range.
using ByRange = std::array<std::uint64_t, range_count>;
inline std::uint64_t both(const ByRange& counts) { return counts[0] + counts[1]; }

struct WayCount {
  ByRange cases{};
  ByRange out_of_range{};          ///< of `rounding`: by overflow or underflow; the rest is by cancellation
  std::optional<Finding> example;  ///< the best, by shown_before; none of `agree` and `unsupported`

  void merge(const WayCount& other);
};

/// One operation and family, or where calls were recorded: operation and call site.
struct Cell {
  std::map<Way, WayCount> ways;
  double worst_ulps = 0;                               ///< over the answers of which whatever is decided is right
  std::uint64_t touches_closed = 0, touches_open = 0;  ///< clear touches answered as closed sets do, as open ones
  std::uint64_t surplus = 0;                           ///< elements that answers which must cover hold beyond the truth
  std::uint64_t apart = 0;                             ///< elements that they might have held beyond it
  std::uint64_t refused = 0;                           ///< drawn, but outside the contract: not a case
  std::uint64_t hash = 0;                              ///< of what was true and answered: a sum over the cases
  std::uint64_t left_out = 0;                          ///< drawn, but extreme where only ordinary questions are asked
  /// At ordinary size: findings but for rounding where a direction has a component of 0, right answers where none has.
  std::uint64_t found_on_axis = 0, right_off_axis = 0;
  std::uint64_t other_nearest = 0;             ///< right answers that break a tie otherwise than the truth
  std::uint64_t other_alternative = 0;         ///< drawn, but of a kind that the engine does not answer
  std::uint64_t not_asked = 0;                 ///< the engine had been given up before their turn: no cases
  std::string given_up;                        ///< why, in the engine's or our words; empty where all were asked
  std::map<std::string, std::uint64_t> rules;  ///< how often which rule refused it, without particulars ("simple")
  Recorded recorded{};                         ///< of calls that were recorded; else empty

  double surplus_rate() const { return apart == 0 ? 0 : static_cast<double>(surplus) / static_cast<double>(apart); }
  std::uint64_t cases() const;
  std::uint64_t cases(Range range) const;
  std::uint64_t count(Verdict verdict) const;
  std::uint64_t count(Verdict verdict, Range range) const;
  std::array<std::uint64_t, verdict_count> counts() const;
  std::uint64_t answered() const;  ///< cases but `unsupported`
  std::uint64_t answered(Range range) const;
  std::uint64_t wrong() const;  ///< `rounding`, `algorithm` and `invalid`: the answer is of no use
  std::uint64_t wrong(Range range) const;
  bool nothing_right() const;      ///< of so many answers that it is the connection which must be looked at first
  std::uint64_t findings() const;  ///< cases whose verdict is a finding: wrong or `inexact`
  std::uint64_t findings(Range range) const;
  ByRange by_range(Verdict verdict) const;
  ByRange out_of_range() const;  ///< of `rounding`: by overflow or underflow
  ByRange cancellation() const;  ///< of `rounding`: the rest
  /// How often the truth was what.
  std::map<std::string, std::uint64_t> truths() const;
  /// How often which truth (first) was answered how (second), whatever the verdict.
  std::map<std::pair<std::string, std::string>, ByRange> confusion() const;
  /// The best example of a verdict, over its ways; nullptr where there is none.
  const Finding* example(Verdict verdict) const;

  /// Of cases of which only the verdict is known.
  static Cell of(const std::array<std::uint64_t, verdict_count>& counts);

  void refuse(const std::string& rule);
  void merge(const Cell& other);

 private:
  ByRange by_range() const;
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
  /// More listed beyond the truth than a broad phase is good for: a finding of its own.
  bool too_much_surplus(double most) const { return total().surplus_rate() > most; }
};

/// Into how many shards the run is cut, and which of them are counted here; of an exhaustive run the grid too. size 0:
/// cases were drawn, and where they are in one part `done` is empty.
struct Grid {
  std::uint64_t size = 0, shards = 1;
  std::vector<std::uint64_t> done;  ///< ascending
};

/// Whoever lists everything has a rate of 1; sorting along one axis, the simplest broad phase, one of about 0.4 on
/// these questions.
inline constexpr double usual_surplus = 0.75;

/// How a finding is found again, and one of a foreign engine asked again, as a shell reads it.
struct Repeat {
  std::string program = "touchstone";
  std::string options;    ///< "--engine 'python3 engine.py'"; empty where the program is the engine's own
  bool recorded = false;  ///< of recorded calls: families are call sites, cases are calls
};

struct Tally {
  std::string version = version_number;
  Declaration declaration;
  Repeat repeat;                      ///< of tallies that are merged the first's
  std::vector<std::string> logs{};    ///< where recorded calls were judged: the files; families are call sites then
  std::uint64_t seed = 0, cases = 0;  ///< per operation, as asked for
  bool by_cost = false;               ///< of operations that cost much there are fewer (audit/counting/cases_of.h)
  Grid grid;
  Limits limits;                        ///< that tell ordinary questions from extreme ones
  double max_surplus = usual_surplus;   ///< of what is apart, the share that lists may hold
  std::vector<std::string> undeclared;  ///< operations that were to be asked and that the engine does not declare
  std::vector<OperationTally> operations;
  std::vector<OperationTally> robust;  ///< the same questions asked to robust
  bool interrupted = false;

  bool has_findings() const;
  /// Whether extreme questions were drawn and left out.
  bool ordinary_only() const;
  /// Throws InvalidInput where the two are of different engines, grids or limits, or count the same cases. Of two seeds
  /// the smaller stays.
  void merge(const Tally& other);
};

}  // namespace touchstone::audit
