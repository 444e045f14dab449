// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/processor.h"

namespace touchstone::robust::kernel {

/// Sets IEEE arithmetic as the standard has it (round to nearest, gradual underflow, no traps) while in scope, then
/// restores the host's settings and exception flags. One shared library linked with -Ofast is enough to make a host
/// flush to zero.
class ControlWord {
 public:
  ControlWord() : host_(processor::control()) {
    if (!processor::is_ieee(host_)) processor::set_ieee();
  }
  ~ControlWord() { processor::set_control(host_); }
  ControlWord(const ControlWord&) = delete;
  ControlWord& operator=(const ControlWord&) = delete;

 private:
  processor::Control host_;
};

}  // namespace touchstone::robust::kernel
