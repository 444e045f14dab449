// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <utility>

#include "audit/uses.h"

namespace touchstone::audit {

/// Time limit in seconds from construction, 0 = none. The clock may be replaced; it returns seconds.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds = 0, std::function<double()> clock = seconds_of_machine)
      : clock_(std::move(clock)), limited_(seconds > 0), end_(limited_ ? clock_() + seconds : 0) {}

  bool over() const { return limited_ && clock_() >= end_; }

  static double seconds_of_machine() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

 private:
  std::function<double()> clock_;
  bool limited_;
  double end_;
};

}  // namespace touchstone::audit
