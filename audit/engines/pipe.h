// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "audit/engines/engine.h"
#include "audit/engines/notes.h"
#include "audit/engines/process.h"
#include "audit/engines/protocol.h"

namespace touchstone::audit {

/// The limits of a foreign process. The counts are per operation: beyond any of them the engine is given up for the
/// rest of it, so that an engine that dies or hangs on every question cannot make a run endless.
struct PipeLimits {
  double timeout = 5;           ///< seconds without any answer while one is due
  double start_timeout = 10;    ///< seconds for the first line
  std::size_t in_flight = 256;  ///< questions asked and not answered yet
  std::size_t line = 1 << 20;   ///< bytes of an answer
  int restarts = 100;
  int restarts_in_a_row = 20;  ///< without an answer in between
  int timeouts = 12;
};

/// An engine behind pipes (docs/engines.md). If it dies, hangs or gives a malformed answer, it is restarted and the
/// questions in flight are asked again one at a time, so that only those are lost that it cannot answer alone. Lines
/// that are not meant as answers are skipped.
class PipeEngine final : public Engine {
 public:
  /// Throws EngineError if it does not start or its first line is malformed. Once *stop is true no further question is
  /// asked.
  PipeEngine(std::string command, const PipeLimits& limits, const std::atomic<bool>* stop = nullptr,
             EngineNotes* notes = nullptr);

  const Declaration& declaration() const override { return hello_.declaration; }
  bool supports(const std::string& operation) const override { return hello_.operations.count(operation) > 0; }
  void ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) override;
  void ask_until(const std::function<bool()>& over) override { over_ = over; }

  int restarts() const { return restarts_; }  ///< in the most recent operation

 private:
  using Clock = std::chrono::steady_clock;
  /// One call of ask_each. Questions are identified by their indices in it.
  struct Round {
    const Metadata& metadata;
    const QuestionText text;
    const std::vector<Question>& questions;
    const Take& take;
    std::uint64_t first_id;
    std::vector<bool> settled;
    std::vector<std::size_t> asked{};  ///< by id - first_id; a repeated question has a second id
    std::size_t owed = 0;
  };
  using Indices = std::deque<std::size_t>;

  void start();
  bool start_again();
  std::string first_line();
  /// Asks and settles everything in `to_ask`; or returns what went wrong, with those in flight in `unanswered`.
  std::optional<std::string> converse(Round& round, Indices& to_ask, std::size_t in_flight, Indices& unanswered);
  std::optional<std::string> exchange(Round& round, Indices& to_ask, std::size_t in_flight);
  void ask_alone(Round& round, Indices& suspects);
  void write_questions(Round& round, Indices& to_ask, std::size_t in_flight);
  std::optional<std::string> take_lines(Round& round);
  std::optional<std::string> take_line(const std::string& line, Round& round);
  void hear_repetitions(Round& round);
  void settle(Round& round, std::size_t index, Reply reply);
  void lose_engine(const std::string& defect);
  std::string why_stop() const;
  bool interrupted() const { return (stop_ != nullptr && *stop_) || (over_ && over_()); }

  std::string command_;
  PipeLimits limits_;
  const std::atomic<bool>* stop_;
  EngineNotes* notes_;
  std::function<bool()> over_;
  Hello hello_;
  std::unique_ptr<Process> process_;
  std::string inbox_, outbox_;
  std::uint64_t next_id_ = 1, first_id_of_process_ = 1;
  bool repeats_itself_ = false;
  std::string operation_, last_defect_, last_stray_;  ///< last_stray_: of the running process
  int restarts_ = 0, restarts_in_a_row_ = 0, timeouts_ = 0;
};

}  // namespace touchstone::audit
