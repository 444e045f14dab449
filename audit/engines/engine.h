// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// The reply to one question.
struct Reply {
  enum class Kind {
    answered,     ///< `answer` holds the answer
    unsupported,  ///< the engine does not have the operation, or not for this input
    failed,       ///< error, crash, timeout, malformed answer: `remark` says which; the judge says `invalid`
  };
  Kind kind = Kind::answered;
  Json answer;
  std::string remark;
  /// False: `failed` because the engine was given up, or the run interrupted, before this question's turn.
  bool asked = true;
  std::size_t bytes = 0;  ///< number of bytes read for it
};

/// A foreign implementation, asked many questions of one operation at a time. A crash or hang costs one question, not
/// the run.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual const Declaration& declaration() const = 0;
  virtual bool supports(const std::string& operation) const = 0;
  /// Receives the reply to the question with that index.
  using Take = std::function<void(std::size_t index, Reply reply)>;
  /// Delivers the reply to each question when it arrives, in any order, and keeps none: a reply may be long. A question
  /// that is answered twice gets a second reply, `failed`, which replaces the first.
  virtual void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) = 0;
  /// One reply per question, in order.
  std::vector<Reply> ask(const Operation& operation, const std::vector<Question>& questions) {
    std::vector<Reply> replies(questions.size());
    ask_each(operation, questions, [&](std::size_t index, Reply reply) { replies[index] = std::move(reply); });
    return replies;
  }
  /// From now on, questions that are not answered when `over` returns true are not waited for, and not asked.
  virtual void ask_until(const std::function<bool()>& over) { static_cast<void>(over); }
};

/// Thrown if the engine cannot be run at all (exit code 3).
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class EngineNotes;

/// Starts `command` (by the shell) and shakes hands as in docs/engines.md. timeout: seconds without an answer. Once
/// *stop is true, no further questions are asked. Further remarks go into `notes`.
std::unique_ptr<Engine> pipe_engine(const std::string& command, double timeout, const std::atomic<bool>* stop = nullptr,
                                    EngineNotes* notes = nullptr);

}  // namespace touchstone::audit
