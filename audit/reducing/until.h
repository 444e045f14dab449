// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "audit/reducing/interest.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

/// Questions on which a user's command ends with exit code 0. The shell runs it anew for each; it reads the question as
/// one line of JSON from its standard input, and its output is ignored. After `timeout` seconds it is killed, which
/// counts as another exit code. Questions outside the contract are not asked unless that is allowed.
class Until final : public Interest {
 public:
  Until(const Operation& operation, std::string command, double timeout, bool allow_invalid)
      : operation_(operation), command_(std::move(command)), timeout_(timeout), allow_invalid_(allow_invalid) {}
  Look look(std::size_t job, const Question& question) override;

 private:
  const Operation& operation_;
  std::string command_;
  double timeout_;
  bool allow_invalid_;
};

}  // namespace touchstone::audit
