// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/pipe.h"

#include <algorithm>
#include <numeric>

#include "catalogue/codec/excerpt.h"

namespace touchstone::audit {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t outbox_filled = 1 << 16;
constexpr std::chrono::milliseconds slice{100};      // how soon an interrupt is noticed
constexpr std::chrono::milliseconds repetition{20};  // time to wait for a second answer, once one has been repeated

Clock::time_point from_now(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

PipeEngine::PipeEngine(std::string command, const PipeLimits& limits, const std::atomic<bool>* stop, EngineNotes* notes)
    : command_(std::move(command)), limits_(limits), stop_(stop), notes_(notes) {
  start();
}

void PipeEngine::ask_each(const Operation& operation, const std::vector<Question>& questions, const Take& take) {
  if (operation.name() != operation_) {
    operation_ = operation.name();
    restarts_ = restarts_in_a_row_ = timeouts_ = 0;
  }
  Round round{
      operation.metadata(), QuestionText(operation), questions, take, next_id_, std::vector<bool>(questions.size())};
  Indices to_ask(questions.size()), unanswered;
  std::iota(to_ask.begin(), to_ask.end(), 0);
  while (!to_ask.empty() && why_stop().empty()) {
    if (!process_ && !start_again()) continue;
    if (converse(round, to_ask, limits_.in_flight, unanswered)) ask_alone(round, unanswered);
    to_ask.insert(to_ask.begin(), unanswered.begin(), unanswered.end());
    unanswered.clear();
  }
  hear_repetitions(round);
  for (const std::size_t index : to_ask) take(index, {Reply::Kind::failed, nullptr, why_stop(), false});
}

/// Settles the suspects, each alone with the engine, until it is given up. An engine that has answered before may have
/// died from that: only questions that a fresh one cannot answer are lost. A timeout is not retried.
void PipeEngine::ask_alone(Round& round, Indices& suspects) {
  Indices alone, unanswered;
  while (!suspects.empty() && why_stop().empty()) {
    if (!process_ && !start_again()) continue;
    const bool fresh = next_id_ == first_id_of_process_;
    const int timeouts = timeouts_;
    alone.assign(1, suspects.front());
    unanswered.clear();
    const auto defect = converse(round, alone, 1, unanswered);
    if (interrupted()) return;
    if (defect && !unanswered.empty()) {
      if (!fresh && timeouts_ == timeouts) continue;
      settle(round, suspects.front(), {Reply::Kind::failed, nullptr, *defect});
    }
    suspects.pop_front();
  }
}

std::optional<std::string> PipeEngine::converse(Round& round, Indices& to_ask, std::size_t in_flight,
                                                Indices& unanswered) {
  const std::size_t first = round.asked.size();
  round.owed = 0;
  const auto defect = exchange(round, to_ask, in_flight);
  if (!defect) return defect;
  lose_engine(*defect);
  for (std::size_t i = first; i < round.asked.size(); ++i) {
    if (!round.settled[round.asked[i]]) unanswered.push_back(round.asked[i]);
  }
  return defect;
}

std::optional<std::string> PipeEngine::exchange(Round& round, Indices& to_ask, std::size_t in_flight) {
  auto deadline = from_now(limits_.timeout);
  while (true) {
    write_questions(round, to_ask, in_flight);
    const std::size_t owed = round.owed;
    if (owed == 0) return std::nullopt;
    process_->wait_for(!outbox_.empty(), std::min(deadline, Clock::now() + slice));
    const bool open = process_->read(inbox_);
    if (auto defect = take_lines(round)) return defect;
    if (!open) return process_->end();
    if (round.owed < owed) {
      deadline = from_now(limits_.timeout);
    } else if (Clock::now() >= deadline) {
      ++timeouts_;
      return "no answer in " + decimal(limits_.timeout) + " s" +
             (last_stray_.empty() ? "" : "; the last line that is no answer: " + last_stray_);
    }
    if (interrupted()) return why_stop();
  }
}

void PipeEngine::write_questions(Round& round, Indices& to_ask, std::size_t in_flight) {
  while (!to_ask.empty() && round.owed < in_flight && outbox_.size() < outbox_filled) {
    append_question_line(next_id_++, round.metadata, round.text, round.questions[to_ask.front()], outbox_);
    round.asked.push_back(to_ask.front());
    to_ask.pop_front();
    ++round.owed;
  }
  std::string_view rest = outbox_;
  process_->write(rest);
  outbox_.erase(0, outbox_.size() - rest.size());
}

std::optional<std::string> PipeEngine::take_lines(Round& round) {
  std::size_t begin = 0;
  for (std::size_t end; (end = inbox_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    if (auto defect = take_line(inbox_.substr(begin, end - begin), round)) return defect;
  }
  inbox_.erase(0, begin);
  if (inbox_.size() > limits_.line)
    return "more than " + std::to_string(limits_.line) + " bytes without the end of a line";
  return std::nullopt;
}

std::optional<std::string> PipeEngine::take_line(const std::string& line, Round& round) {
  AnswerLine answer;
  try {
    answer = read_answer_line(line);
    answer.reply.bytes = line.size();
  } catch (const InvalidInput& wrong) {
    if (meant_as_answer(line))
      return "a line that is no answer (" + std::string(wrong.what()) + "): " + excerpt(line, 60);
    last_stray_ = excerpt(line, 60);
    if (notes_ != nullptr) notes_->add_stray_line(line);
    return std::nullopt;
  }
  if (answer.id < first_id_of_process_ || answer.id >= next_id_) {
    return "an answer to a question that was not asked: id " + std::to_string(answer.id);
  }
  if (answer.id < round.first_id) {
    repeats_itself_ = true;  // the call that asked it has returned; from now on repetitions are waited for
    return std::nullopt;
  }
  const std::size_t index = round.asked[answer.id - round.first_id];
  if (round.settled[index]) {
    repeats_itself_ = true;
    round.take(index, {Reply::Kind::failed, nullptr, "answered twice"});
    return std::nullopt;
  }
  --round.owed;
  restarts_in_a_row_ = 0;
  settle(round, index, std::move(answer.reply));
  return std::nullopt;
}

/// Ensures that repeated answers are found whatever the load of the machine. Engines that do not repeat themselves
/// never wait here.
void PipeEngine::hear_repetitions(Round& round) {
  const auto deadline = Clock::now() + repetition;
  while (repeats_itself_ && process_ && Clock::now() < deadline) {
    process_->wait_for(false, deadline);
    const bool open = process_->read(inbox_);
    if (const auto defect = take_lines(round); defect || !open) lose_engine(defect.value_or("its output ended"));
  }
}

void PipeEngine::settle(Round& round, std::size_t index, Reply reply) {
  round.settled[index] = true;
  round.take(index, std::move(reply));
}

void PipeEngine::start() {
  inbox_.clear();
  outbox_ = greeting();
  last_stray_.clear();
  first_id_of_process_ = next_id_;
  std::string first;
  try {
    process_ = std::make_unique<Process>(command_);
    first = first_line();
    hello_ = read_hello(first);
    for (const std::string& remark : hello_.remarks) {
      if (notes_ != nullptr) notes_->add_of_first_line(remark);
    }
  } catch (const InvalidInput& wrong) {
    process_.reset();
    const std::string what = wrong.field() == "line"
                                 ? R"(expected {"engine":"NAME","ops":["OPERATION",...]}, got )" + excerpt(first, 60)
                                 : wrong.what();
    throw EngineError("engine " + command_ + ": first line: " + what);
  } catch (const std::exception& failed) {
    process_.reset();
    throw EngineError("engine " + command_ + ": " + failed.what());
  }
}

std::string PipeEngine::first_line() {
  const auto deadline = from_now(limits_.start_timeout);
  while (true) {
    std::string_view rest = outbox_;
    process_->write(rest);
    outbox_.erase(0, outbox_.size() - rest.size());
    process_->wait_for(!outbox_.empty(), std::min(deadline, Clock::now() + slice));
    const bool open = process_->read(inbox_);
    if (const std::size_t end = inbox_.find('\n'); end != std::string::npos) {
      std::string line = inbox_.substr(0, end);
      inbox_.erase(0, end + 1);
      return line;
    }
    if (!open) throw EngineError("it said nothing and ended: " + process_->end());
    if (inbox_.size() > limits_.line) throw EngineError("its first line does not end");
    if (Clock::now() >= deadline) {
      ++timeouts_;
      throw EngineError("no first line in " + decimal(limits_.start_timeout) +
                        " s (is its output flushed after every line? does it start slowly? --timeout gives it more)");
    }
    if (interrupted()) throw EngineError("interrupted");
  }
}

bool PipeEngine::start_again() {
  try {
    start();
    return true;
  } catch (const EngineError& error) {
    lose_engine(error.what());
    return false;
  }
}

void PipeEngine::lose_engine(const std::string& defect) {
  process_.reset();
  last_defect_ = defect;
  if (notes_ != nullptr && !interrupted()) notes_->add_restart(defect);
  ++restarts_;
  ++restarts_in_a_row_;
}

std::string PipeEngine::why_stop() const {
  const auto after = [this](int count, const char* what) {
    return "given up after " + std::to_string(count) + what + ", the last for: " + last_defect_;
  };
  if (interrupted()) return "interrupted";
  if (restarts_ >= limits_.restarts) return after(restarts_, " restarts in this operation");
  if (restarts_in_a_row_ >= limits_.restarts_in_a_row) return after(restarts_in_a_row_, " restarts in a row");
  if (timeouts_ >= limits_.timeouts) return after(timeouts_, " questions without an answer in time");
  return "";
}

std::unique_ptr<Engine> pipe_engine(const std::string& command, double timeout, const std::atomic<bool>* stop,
                                    EngineNotes* notes) {
  PipeLimits limits;
  limits.timeout = timeout;
  limits.start_timeout = 2 * timeout;
  return std::make_unique<PipeEngine>(command, limits, stop, notes);
}

}  // namespace touchstone::audit
