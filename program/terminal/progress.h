// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <ostream>
#include <string>
#include <vector>

#include "catalogue/operation/operation.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The progress of a run and its estimated remaining time, from the relative costs of the operations. On a terminal one
/// line, rewritten at most ten times a second and removed at the end; otherwise a line every ten seconds, so that a log
/// shows that the run is alive. Never coloured.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  /// `cases` of each operation will be asked, in this order. `now` returns the time.
  Progress(std::ostream& err, bool terminal, const std::vector<const Operation*>& operations, std::uint64_t cases,
           std::function<Clock::time_point()> now = Clock::now);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Fewer cases are asked of expensive operations (audit/counting/cases_of.h).
  void ask_by_cost();
  /// Skips these operations.
  void leave_out(const std::function<bool(const Operation&)>& not_asked);
  /// The number of operations.
  std::size_t operations() const { return shares_.size(); }
  /// Clears the line of a terminal; the operations' cases are no longer shown after that.
  void end();
  /// Shows the steps after them: "report: 12 of 53, orientation". Needs another end() when done.
  void step(const std::string& what, const std::string& name, std::size_t done, std::size_t all);

  /// Shows another line, for a run that is not counted by operations.
  void tell(const std::string& text);

  /// Reports that `done` cases of an operation are finished. May be called from any thread.
  void operator()(const std::string& operation, std::uint64_t done);
  /// Reports that all are, and how many findings have been shrunk: "12 %, octree (3 of 84), making 12 findings smaller:
  /// 3 of 12".
  void smaller(const std::string& operation, std::size_t done, std::size_t all);

 private:
  struct Share {
    const Operation* operation;
    std::uint64_t cases = 0;
    double before = 0, weight = 0;  ///< of the total
  };
  /// Its share, unless it is not shown.
  const Share* share_of(const std::string& operation) const;
  double done_with(const Share& share, double part) const { return share.before + share.weight * part; }
  /// "12 %, octree (3 of 84)"
  std::string place(const Share& share, double whole) const;
  std::string line(const Share& share, std::uint64_t done, Clock::time_point now) const;

  void share_out();
  /// Prints if it is time for another line.
  void show(const std::string& text, Clock::time_point now);

  std::ostream& err_;
  bool terminal_;
  std::vector<Share> shares_;
  std::uint64_t cases_;
  std::function<Clock::time_point()> now_;
  Clock::time_point started_, last_;
  std::mutex mutex_;
  bool ended_ = false, shown_ = false, by_cost_ = false;
};

/// "40 s", "12 min", "3 h"
std::string in_words(std::chrono::duration<double> time);

/// The progress of a run that is counted as one.
struct Pace {
  double part;  ///< of the total
  std::uint64_t done;
  const char* noun;  ///< what is counted: "case"
  double rate;       ///< per second
  double seconds_left;
};
/// "34 %, 1,234,567 cases, 12,345 a second, about 2 min left"
std::string in_words(const Pace& pace);

}  // namespace touchstone::program
