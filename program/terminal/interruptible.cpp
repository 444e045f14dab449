// SPDX-License-Identifier: Apache-2.0
#include "program/terminal/interruptible.h"

namespace touchstone::program {
namespace {

std::atomic<bool> came{false};
extern "C" void on_interrupt(int) { came = true; }

}  // namespace

Interruptible::Interruptible()
    : by_key_(std::signal(SIGINT, on_interrupt)), by_others_(std::signal(SIGTERM, on_interrupt)) {}

Interruptible::~Interruptible() {
  std::signal(SIGINT, by_key_);
  std::signal(SIGTERM, by_others_);
}

const std::atomic<bool>& Interruptible::stopped() { return came; }

}  // namespace touchstone::program
