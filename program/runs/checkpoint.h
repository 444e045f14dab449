// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>

#include "catalogue/codec/json.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The state of a long run in FILE.part, beside FILE, its result: replaced by rename every few seconds and removed once
/// the result is there. The same run started again goes on from it, however it was stopped.
class Checkpoint {
 public:
  /// `run`: what makes a run this one, its options and the program's version. Without a file nothing is kept. Throws
  /// UsageError where FILE.part is not of this run.
  Checkpoint(const std::string& file, Json run, std::ostream& err);

  /// The state of the run that was stopped, with numbers as parse_line reads them; null if there is none.
  const Json& found() const { return found_; }
  /// Where it is kept; empty: nowhere.
  const std::string& file() const { return part_; }

  /// Keeps the state if it is time to.
  void keep(const std::function<Json()>& state);
  void keep_now(const Json& state) const;
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string part_, run_;
  Json found_ = nullptr;
  Clock::time_point began_ = Clock::now(), kept_ = began_;
};

}  // namespace touchstone::program
