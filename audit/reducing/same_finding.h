// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "audit/engines/engine.h"
#include "audit/reducing/interest.h"

namespace touchstone::audit {

/// The implementation whose answers are judged while a question is reduced.
class Respondent {
 public:
  virtual ~Respondent() = default;
  virtual const Declaration& declaration() const = 0;
  virtual Reply reply(std::size_t job, const Operation& operation, const Question& question) = 0;
  virtual Judgement judgement(const Reply& reply, const Examination& examination) const = 0;
};
/// An engine for each job.
std::unique_ptr<Respondent> respondent(std::vector<std::unique_ptr<Engine>> engines);
/// The textbook formula in double or in float.
std::unique_ptr<Respondent> formula_as_respondent(bool binary32);

struct SameFindingOptions {
  bool any_answer = false;     ///< the same cause suffices, whatever the truth and the answer
  bool allow_invalid = false;  ///< for crashes: questions outside the contract are asked, too
};

/// Questions on which the respondent is wrong as on the first: with the same cause (`cancellation`, `out_of_range`,
/// `algorithm` ...), and the enumerators of the answer that differ from the truth's are the same, as are the truth's
/// there; if it gave no answer, with the same exit code, signal or complaint.
///
/// The exact truth is only computed for questions on which an answer differs from robust's. If that, or the cause, is
/// too expensive (steps_too_many), answers must differ from robust's in the same enumerators; the cause is then that of
/// the first question that is small enough.
class SameFinding final : public Interest {
 public:
  SameFinding(const Operation& operation, Respondent& respondent, const SameFindingOptions& options);

  /// Determines the defect on this question; must be called first. Returns the reason why there is nothing to reduce,
  /// or "". Throws InvalidInput if the question is outside the contract.
  std::string begin(const Question& question);

  Look look(std::size_t job, const Question& question) override;
  Question fitted(const Question& question) const override;
  void go_on_with(const Question& question) override;

 private:
  struct Target {
    std::string cause, reason;  ///< empty cause: not known yet
    bool no_answer = false;     ///< the engine failed
    std::string difference;     ///< the enumerators in which the answer is wrong: "inside, not outside"
  };
  bool matches(const Target& found) const;
  static Target failure(const Reply& reply);
  /// The defect of an answer in words; nullopt if it has the same as robust's.
  std::optional<Target> against_robust(const Json& answer, const EncodedValue<double>& robust) const;
  std::optional<Target> examined(const Question& question, const Reply& reply) const;

  const Operation& operation_;
  Respondent& respondent_;
  SameFindingOptions options_;
  Target target_;
};

/// True if the exact truth of a question and the cause of a wrong answer take too many steps to be computed repeatedly.
/// In steps, so that it is the same on every machine.
bool steps_too_many(const Operation& operation, const Question& question);

/// The way in which an engine failed: its exit code or signal, or its complaint without the numbers that are particular
/// to the question.
std::string reason_of(const std::string& remark);

}  // namespace touchstone::audit
