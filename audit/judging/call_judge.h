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

/// Judges recorded calls and counts them by operation and call site. What is counted does not depend on the order of
/// the calls. For one thread at a time.
///
/// A call is vouched for, and not examined, where the textbook formula under running error analysis is further from any
/// other course than rounding can carry it, so that nothing touches, and the recorded answer is robust's: every number
/// bit for bit, or the decision where it has no numbers. One of many such calls is examined all the same. All others
/// are held against the oracle.
class CallJudge {
 public:
  CallJudge(Declaration declaration, const Limits& limits);

  void judge(const RecordedCall& call);
  /// The call was not asked, because the engine had been given up.
  void leave(const RecordedCall& call, const std::string& why);

  /// How many calls were of functions over float, and over double.
  std::uint64_t in_float() const { return in_float_; }
  std::uint64_t in_double() const { return in_double_; }

  struct Counted {
    Cell answers, robust;
  };
  /// By operation and place in the sites of the log; what was counted is handed over.
  std::map<std::pair<const Operation*, std::size_t>, Counted> take();

 private:
  /// The enumerators of an answer, by the words that it consists of.
  struct Outcome {
    std::vector<Word> words;
    std::string name;
    std::optional<bool> yes;
  };
  /// What one operation's answers are compared by.
  struct Reader {
    bool decides = false;   ///< an answer has an enumerator
    bool by_words = false;  ///< whatever an answer decides are enumerators that stand in it once
    std::deque<Outcome> complete{}, partial{};
  };
  /// Right answers of one kind that were vouched for.
  struct Vouched {
    std::string truth, said;
    std::string way;  ///< as count() writes it
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
  /// How the answer is called that is the same as robust's; nullptr where it is another or cannot be told quickly.
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
