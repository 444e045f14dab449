// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "audit/uses.h"
#include "catalogue/shape/encoded_value.h"

namespace touchstone::audit {

enum class Look {
  holds,
  fails,
  refused,  ///< outside the contract of the operation
};

/// What a question must go on to show while it is reduced.
class Interest {
 public:
  virtual ~Interest() = default;
  /// Whether it does. Calls of different jobs, which count from 0, may come at one time.
  virtual Look look(std::size_t job, const Question& question) = 0;
  /// The question as it can be asked: its numbers rounded to floats where the engine takes floats.
  virtual Question fitted(const Question& question) const { return question; }
  /// From now on this question, which holds, is reduced. No look goes on meanwhile.
  virtual void go_on_with(const Question& question) { static_cast<void>(question); }
};

}  // namespace touchstone::audit
