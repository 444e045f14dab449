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

/// The property that a question must keep while it is reduced.
class Interest {
 public:
  virtual ~Interest() = default;
  /// Returns whether it has it. Calls of different jobs, counted from 0, may be concurrent.
  virtual Look look(std::size_t job, const Question& question) = 0;
  /// The question in askable form: its numbers rounded to floats if the engine takes floats.
  virtual Question fitted(const Question& question) const { return question; }
  /// From now on this question, which has the property, is reduced. No look is running meanwhile.
  virtual void go_on_with(const Question& question) { static_cast<void>(question); }
};

}  // namespace touchstone::audit
