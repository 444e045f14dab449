// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "program/terminal/uses.h"

namespace touchstone::program {

enum ExitCode { nothing_found = 0, findings = 1, bad_usage = 2, engine_failed = 3, interrupted = 130 };

/// Wrong usage: one line, exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace touchstone::program
