// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <csignal>

#include "program/terminal/uses.h"

namespace touchstone::program {

/// SIGINT and SIGTERM end the asking instead of the program, for as long as this lives.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

  /// Whether one of them came, since the program began.
  static const std::atomic<bool>& stopped();

 private:
  void (*by_key_)(int);
  void (*by_others_)(int);
};

}  // namespace touchstone::program
