// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <ostream>
#include <string>

#include "catalogue/codec/json.h"
#include "program/terminal/uses.h"

namespace touchstone::program {

/// The state of a long run in FILE.part, next to FILE, its result: replaced by rename every few seconds and removed
/// once the result exists. The same run continues from it when restarted, however it was interrupted.
class Checkpoint {
 public:
  /// `run`: identifies the run by its options and the program's version. Without a file nothing is kept. Throws
  /// UsageError if FILE.part belongs to another run.
  Checkpoint(const std::string& file, Json run, std::ostream& err);

  /// The state of the interrupted run, with numbers as parse_line reads them; null if there is none.
  const Json& found() const { return found_; }
  /// The file that holds it; empty: none.
  const std::string& file() const { return part_; }

  /// Saves the state if it is time to.
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
