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

/// What came back for one question.
struct Reply {
  enum class Kind {
    answered,     ///< `answer` holds it
    unsupported,  ///< the engine does not have the operation, or not for this input
    failed,       ///< error, crash, time-out, nonsense: `remark` says which; the judge says `invalid`
  };
  Kind kind = Kind::answered;
  Json answer;
  std::string remark;
  /// False: `failed` because the engine was given up, or the run stopped, before it was this question's turn.
  bool asked = true;
  std::size_t bytes = 0;  ///< that were read for it
};

/// Somebody's implementation, asked many questions of one operation at a time. It loses a question when it crashes or
/// hangs, never the run.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual const Declaration& declaration() const = 0;
  virtual bool supports(const std::string& operation) const = 0;
  /// Receives the reply to the question of that index.
  using Take = std::function<void(std::size_t index, Reply reply)>;
  /// Hands over the reply to each question when it comes, in any order, and keeps none: a reply may be long. A question
  /// that is answered a second time has a second reply, `failed`, which replaces the first.
  virtual void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) = 0;
  /// One reply per question, in order.
  std::vector<Reply> ask(const Operation& operation, const std::vector<Question>& questions) {
    std::vector<Reply> replies(questions.size());
    ask_each(operation, questions, [&](std::size_t index, Reply reply) { replies[index] = std::move(reply); });
    return replies;
  }
  /// From now on, what has not been answered yet when `over` says true is not waited for, and is not asked.
  virtual void ask_until(const std::function<bool()>& over) { static_cast<void>(over); }
};

/// Thrown where the engine cannot be run at all (exit code 3).
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class EngineNotes;

/// Starts `command` (by the shell) and shakes hands as in docs/engines.md. timeout: seconds without an answer. Once
/// *stop is true, what has not been asked yet is not asked any more. Further remarks go into `notes`.
std::unique_ptr<Engine> pipe_engine(const std::string& command, double timeout, const std::atomic<bool>* stop = nullptr,
                                    EngineNotes* notes = nullptr);

}  // namespace touchstone::audit
