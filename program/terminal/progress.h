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

/// How far a run is and about how long it still takes, from what the operations cost in relation to each other. On a
/// terminal one line, rewritten at most ten times a second and gone at the end; elsewhere a line every ten seconds, so
/// that a log shows that the run lives. Never a colour.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;
  /// `cases` of each operation will be asked, in this order. `now` is asked for the time.
  Progress(std::ostream& err, bool terminal, const std::vector<const Operation*>& operations, std::uint64_t cases,
           std::function<Clock::time_point()> now = Clock::now);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Fewer cases are asked of operations that cost much (audit/counting/cases_of.h).
  void ask_by_cost();
  /// These operations are not asked after all.
  void leave_out(const std::function<bool(const Operation&)>& not_asked);
  /// How many are.
  std::size_t operations() const { return shares_.size(); }
  /// Clears the line of a terminal; of the operations' cases nothing is shown after that.
  void end();
  /// What follows them: "report: 12 of 53, orientation". Ended once more when it is done.
  void step(const std::string& what, const std::string& name, std::size_t done, std::size_t all);

  /// Another line, of a run that is not counted by operations.
  void tell(const std::string& text);

  /// So many cases of an operation are done. May be called from any thread.
  void operator()(const std::string& operation, std::uint64_t done);
  /// All are, and so many findings are made smaller: "12 %, octree (3 of 84), making 12 findings smaller: 3 of 12".
  void smaller(const std::string& operation, std::size_t done, std::size_t all);

 private:
  struct Share {
    const Operation* operation;
    std::uint64_t cases = 0;
    double before = 0, weight = 0;  ///< of the whole
  };
  /// Its share, unless nothing is to be shown of it.
  const Share* share_of(const std::string& operation) const;
  double done_with(const Share& share, double part) const { return share.before + share.weight * part; }
  /// "12 %, octree (3 of 84)"
  std::string place(const Share& share, double whole) const;
  std::string line(const Share& share, std::uint64_t done, Clock::time_point now) const;

  void share_out();
  /// If it is time for another line.
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

/// How far a run is that is counted as one.
struct Pace {
  double part;  ///< of the whole
  std::uint64_t done;
  const char* noun;  ///< what is counted: "case"
  double rate;       ///< a second
  double seconds_left;
};
/// "34 %, 1,234,567 cases, 12,345 a second, about 2 min left"
std::string in_words(const Pace& pace);

}  // namespace touchstone::program
