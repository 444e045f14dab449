// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/logs/recorded_call.h"

namespace touchstone::audit {

/// Judges recorded calls and counts them by operation and call site. The counts do not depend on the order of the
/// calls. Not thread-safe.
///
/// A call is vouched for, and not examined, if the textbook formula under running error analysis is further from any
/// other course than rounding can carry it, so that nothing touches, and if the recorded answer equals robust's: every
/// number bit for bit, or the decision if it has no numbers. One of many such calls is examined all the same. All
/// others are compared with the oracle.
class CallJudge {
 public:
  CallJudge(Declaration declaration, const Limits& limits);

  void judge(const RecordedCall& call);
  /// Counts a call that was not asked because the engine had been given up.
  void leave(const RecordedCall& call, const std::string& why);

  /// The numbers of calls of functions over float, and over double.
  std::uint64_t in_float() const { return in_float_; }
  std::uint64_t in_double() const { return in_double_; }

  struct Counted {
    Cell answers, robust;
  };
  /// The counts by operation and index among the sites of the log; moves them out.
  std::map<std::pair<const Operation*, std::size_t>, Counted> take();

 private:
  /// The enumerators of an answer, by the words that it consists of.
  struct Outcome {
    std::vector<Word> words;
    std::string name;
    std::optional<bool> yes;
  };
  /// The parts by which one operation's answers are compared.
  struct Reader {
    bool decides = false;   ///< an answer has an enumerator
    bool by_words = false;  ///< everything that an answer decides is enumerators at fixed positions
    std::deque<Outcome> complete{}, partial{};
  };
  /// Right answers of one kind that were vouched for.
  struct Vouched {
    std::string truth, said;
    std::string outcome;  ///< as count() writes it
    ByRange cases{};
    std::uint64_t hash = 0;
  };
  struct Site {
    Counted counted;
    std::vector<Vouched> answers{};
  };

  Reader& reader_of(const Operation& operation);
  static const Outcome& outcome_of_words(const Operation& operation, std::deque<Outcome>& known,
                                         const std::vector<Word>& words, bool partial);
  /// The name of the answer if it equals robust's; nullptr if it differs or cannot be decided quickly.
  const std::string* same_answer(const RecordedCall& call, const EncodedValue<double>& robust, const Outcome& truth,
                                 Reader& reader);
  void vouch(Site& site, const RecordedCall& call, const std::string& truth, const std::string& said);
  /// Returns the truth's enumerators.
  std::string examine(Site& site, const RecordedCall& call);

  Declaration declaration_;
  Limits limits_;
  std::uint64_t in_float_ = 0, in_double_ = 0;
  std::map<const Operation*, Reader> readers_;
  std::map<std::pair<const Operation*, std::size_t>, Site> sites_;
};

}  // namespace touchstone::audit
