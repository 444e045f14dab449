// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>

#include "program/terminal/uses.h"

namespace touchstone::program {

/// While this lives, SIGINT and SIGTERM stop the run instead of the program.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// True if one of them has arrived since the program began.
  static const std::atomic<bool>& stopped();

 private:
  void (*by_key_)(int);
  void (*by_others_)(int);
};

}  // namespace touchstone::program
